<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Soap;

/** A value of a map whose entries say themselves of which type they are. */
final readonly class MapValue
{
    public static function of(string $text, string $type): string|int|float|bool
    {
        return match (true) {
            $type === 'boolean' => $text === 'true',
            // Whole numbers stay whole, as they are in REST.
            $type === 'number' && is_numeric($text) => $text + 0,
            default => $text,
        };
    }
}
