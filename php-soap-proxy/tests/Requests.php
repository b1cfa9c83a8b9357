<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Http\Request;

/** Requests as browsers make them. */
final class Requests
{
    public const NOW = 1_800_000_000;

    /** @param array<string, mixed> $query @param array<string, string> $headers */
    public static function get(array $query = [], array $headers = [], int $time = self::NOW): Request
    {
        return new Request('GET', $query, $headers + ['host' => 'page.test'], '', $time, false);
    }

    /** @param array<string, string> $headers */
    public static function post(string $body, array $headers = [], int $time = self::NOW): Request
    {
        $headers += ['host' => 'page.test', 'content-type' => 'application/json'];
        return new Request('POST', [], $headers, $body, $time, false);
    }
}
