<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy;

use RuntimeException;

/** Why a request was not carried out, as RFC 9457 has it: the members are those that REST answers with. */
final class Problem extends RuntimeException
{
    /** @param array<string, mixed> $members of problem+json; type, title, status, detail and code are there */
    public function __construct(public readonly array $members)
    {
        parent::__construct((string) $members['detail']);
    }

    /** One that this proxy finds, not the server. @param string $kind what type it is of; see docs/problems.md */
    public static function own(int $status, string $kind, string $code, string $title, string $detail): self
    {
        return new self([
            'type' => "urn:dronemap:problem:$kind",
            'title' => $title,
            'status' => $status,
            'detail' => $detail,
            'code' => $code,
            'parameters' => (object) [],
        ]);
    }

    /** A value that cannot be written as SOAP, in the words that the server has for it. */
    public static function value(string $code, string $field, string $detail, string $allowed): self
    {
        return new self([
            'type' => 'urn:dronemap:problem:invalid-value',
            'title' => 'A value is missing or out of range',
            'status' => 422,
            'detail' => $detail,
            'code' => $code,
            'parameters' => ['allowed' => $allowed, 'field' => $field],
            'field' => $field,
            'allowed' => $allowed,
        ]);
    }

    public function status(): int
    {
        return (int) $this->members['status'];
    }
}
