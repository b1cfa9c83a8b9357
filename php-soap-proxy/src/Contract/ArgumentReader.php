<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

use Dronemap\SoapProxy\Http\Request;
use Dronemap\SoapProxy\Problem;
use stdClass;

/** Reads what a page sends into what SOAP takes: known names only, each of its type; ranges are the server's matter. */
final readonly class ArgumentReader
{
    private const PLAIN = [
        'string' => 'a text',
        'dateTime' => 'a text',
        'base64Binary' => 'a text in base64',
        'boolean' => 'true or false',
        'int' => 'a whole number',
        'long' => 'a whole number',
        'double' => 'a number',
    ];

    public function __construct(private Contract $contract)
    {
    }

    /** The body of a POST, the query of a GET. @return array<string, mixed> */
    public function read(Operation $operation, Request $request): array
    {
        $given = $request->method === 'POST'
            ? (array) $request->json()
            : $this->fromTexts($operation, array_diff_key($request->query, ['operation' => '']));
        return $this->members($operation->parameters, $given, '');
    }

    /** A query has texts alone: they become what their type says. @param array<string, mixed> $query @return array<string, mixed> */
    private function fromTexts(Operation $operation, array $query): array
    {
        $given = [];
        foreach ($query as $name => $text) {
            $type = Type::bare($operation->parameters[$name] ?? 'string');
            if (!is_string($text) || !isset(self::PLAIN[$type])) {
                throw $this->malformed((string) $name, 'sent in the body of a POST, as JSON');
            }
            $given[$name] = match ($type) {
                'boolean' => match ($text) {
                    'true' => true,
                    'false' => false,
                    default => $text,
                },
                'int', 'long' => filter_var($text, FILTER_VALIDATE_INT, FILTER_NULL_ON_FAILURE) ?? $text,
                'double' => is_numeric($text) ? (float) $text : $text,
                default => $text,
            };
        }
        return $given;
    }

    /**
     * @param array<string, string> $types
     * @param array<string, mixed> $given
     * @return array<string, mixed>
     */
    private function members(array $types, array $given, string $within): array
    {
        foreach (array_keys($given) as $name) {
            if (!isset($types[$name])) {
                $known = implode(', ', array_keys($types));
                $detail = "There is no member \"$name\" here; there are: $known.";
                throw Problem::value('member-unknown', $within . $name, $detail, $known);
            }
        }
        $read = [];
        foreach ($types as $name => $type) {
            if (array_key_exists($name, $given)) {
                $read[$name] = $this->value(Type::bare($type), $given[$name], $within . $name);
            } elseif (Type::isNeeded($type)) {
                // As null, so that the server says in its words that it is missing, and what it may be.
                $read[$name] = null;
            }
        }
        return $read;
    }

    private function value(string $type, mixed $value, string $field): mixed
    {
        if ($value === null) {
            return null;
        }
        if (str_starts_with($type, 'list of ')) {
            return $this->list(substr($type, 8), $value, $field);
        }
        $members = $this->contract->members($type);
        if ($members === null) {
            return $this->plain($type, $value, $field);
        }
        if (!$value instanceof stdClass) {
            throw $this->malformed($field, 'an object');
        }
        return $this->members($members, (array) $value, "$field.");
    }

    /** @return array{item: list<mixed>} */
    private function list(string $type, mixed $values, string $field): array
    {
        if (!is_array($values)) {
            throw $this->malformed($field, 'a list');
        }
        $items = [];
        foreach ($values as $at => $value) {
            $items[] = $this->value($type, $value, "{$field}[$at]");
        }
        return ['item' => $items];
    }

    private function plain(string $type, mixed $value, string $field): mixed
    {
        $fits = match ($type) {
            'boolean' => is_bool($value),
            'int', 'long' => is_int($value),
            'double' => is_int($value) || is_float($value),
            default => is_string($value),
        };
        if (!$fits) {
            throw $this->malformed($field, self::PLAIN[$type]);
        }
        // SoapClient writes such bytes in base64 itself.
        return $type === 'base64Binary' ? (string) base64_decode($value, true) : $value;
    }

    private function malformed(string $field, string $allowed): Problem
    {
        return Problem::value('value-malformed', $field, "\"$field\" must be $allowed.", $allowed);
    }
}
