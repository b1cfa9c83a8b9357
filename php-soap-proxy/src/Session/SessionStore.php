<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Session;

/** Where the session that a browser's cookie names is kept. */
interface SessionStore
{
    /** What is kept for this browser; empty where there is no session. @return array<string, mixed> */
    public function read(): array;

    /** A session under a new name, whatever there was before. @param array<string, mixed> $values */
    public function begin(array $values): void;

    /** @param array<string, mixed> $values instead of those that are kept */
    public function keep(array $values): void;

    public function end(): void;
}
