<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

use Dronemap\SoapProxy\Soap\MapValue;
use stdClass;

/** Writes what SOAP answers as JSON has it: lists and maps without the elements that SOAP has round them. */
final readonly class AnswerWriter
{
    public function __construct(private Contract $contract)
    {
    }

    public function write(?string $type, mixed $value): mixed
    {
        if ($type === null || $value === null) {
            return null;
        }
        $type = Type::bare($type);
        if (str_starts_with($type, 'list of ')) {
            $items = $value instanceof stdClass ? $value->item ?? [] : [];
            return array_map(fn (mixed $item): mixed => $this->write(substr($type, 8), $item), $items);
        }
        if (str_starts_with($type, 'map of ')) {
            return $this->map(substr($type, 7), $value);
        }
        $members = $this->contract->members($type);
        if ($members === null) {
            return $type === 'base64Binary' ? base64_encode((string) $value) : $value;
        }
        return $this->object($members, $value);
    }

    /** @param array<string, string> $members */
    private function object(array $members, mixed $value): stdClass
    {
        $written = new stdClass();
        foreach ((array) $value as $name => $member) {
            // A server that is newer may have more than is known here.
            if (isset($members[$name])) {
                $written->{$name} = $this->write($members[$name], $member);
            }
        }
        // SOAP leaves out what nobody knows; REST says null.
        foreach ($members as $name => $type) {
            if (Type::mayBeNull($type) && !property_exists($written, $name)) {
                $written->{$name} = null;
            }
        }
        return $written;
    }

    private function map(string $type, mixed $value): stdClass
    {
        $written = new stdClass();
        foreach ($value instanceof stdClass ? $value->entry ?? [] : [] as $entry) {
            $written->{$entry->key} = $type === 'plain'
                ? MapValue::of((string) $entry->_, $entry->type)
                : $this->write($type, $entry);
        }
        return $written;
    }
}
