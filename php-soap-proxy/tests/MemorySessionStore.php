<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Session\SessionStore;

/** One browser's session, kept by a test. */
final class MemorySessionStore implements SessionStore
{
    /** @var array<string, mixed> */
    public array $values = [];
    public int $kept = 0;

    public function read(): array
    {
        return $this->values;
    }

    public function begin(array $values): void
    {
        $this->values = $values;
    }

    public function keep(array $values): void
    {
        $this->values = $values;
        $this->kept++;
    }

    public function end(): void
    {
        $this->values = [];
    }
}
