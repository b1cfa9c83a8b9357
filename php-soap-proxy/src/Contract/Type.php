<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

/**
 * How contract.php writes a type: one of XML Schema (`double`), the name of one of its `types`, or `list of`, `map of`
 * one; then `?` where the member may be left out, `|null` where that means that nobody knows it.
 */
final readonly class Type
{
    public static function bare(string $type): string
    {
        return str_ends_with($type, '|null') ? substr($type, 0, -5) : rtrim($type, '?');
    }

    public static function isNeeded(string $type): bool
    {
        return !str_ends_with($type, '?') && !self::mayBeNull($type);
    }

    public static function mayBeNull(string $type): bool
    {
        return str_ends_with($type, '|null');
    }
}
