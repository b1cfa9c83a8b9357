<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy;

use InvalidArgumentException;

/** What the environment says of this proxy; see README.md. */
final readonly class Settings
{
    private function __construct(
        /** Where the Dronemap server is, such as http://127.0.0.1:8080, without a slash at its end. */
        public string $server,
        /** A file with certificates that the server's one is checked by; null: those of this machine. */
        public ?string $authority,
        /** Where sessions are kept; null: where php.ini says. */
        public ?string $sessions,
        /** How long the server may take to answer, beside what a command is asked to wait for. */
        public int $patienceSeconds,
    ) {
    }

    /** @param array<string, string> $environment */
    public static function from(array $environment): self
    {
        $server = rtrim($environment['DRONEMAP_PHP_SERVER'] ?? 'http://127.0.0.1:8080', '/');
        if (preg_match('#^https?://[^/?\#\s]+$#', $server) !== 1) {
            throw new InvalidArgumentException(
                "DRONEMAP_PHP_SERVER is '$server'; it must be an address such as http://127.0.0.1:8080."
            );
        }
        $patience = $environment['DRONEMAP_PHP_PATIENCE'] ?? '15';
        if (preg_match('/^\d{1,3}$/', $patience) !== 1 || (int) $patience < 1 || (int) $patience > 600) {
            throw new InvalidArgumentException(
                "DRONEMAP_PHP_PATIENCE is '$patience'; it must be a whole number of seconds from 1 to 600."
            );
        }
        return new self(
            $server,
            $environment['DRONEMAP_PHP_AUTHORITY'] ?? null,
            $environment['DRONEMAP_PHP_SESSIONS'] ?? null,
            (int) $patience,
        );
    }
}
