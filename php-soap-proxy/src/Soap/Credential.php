<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Soap;

/** What the server is shown: the value of the header Authorization. */
final readonly class Credential
{
    private function __construct(public string $header)
    {
    }

    public static function key(string $key): self
    {
        return new self("Bearer $key");
    }

    public static function password(string $name, string $password): self
    {
        return new self('Basic ' . base64_encode("$name:$password"));
    }
}
