<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Session;

/**
 * Closes an access key with a token that only the page has, so that neither the session's file alone nor its cookie
 * alone gives the key away.
 */
final readonly class Seal
{
    public static function newToken(): string
    {
        return bin2hex(random_bytes(32));
    }

    public static function close(string $text, string $token): string
    {
        $nonce = random_bytes(SODIUM_CRYPTO_SECRETBOX_NONCEBYTES);
        return base64_encode($nonce . sodium_crypto_secretbox($text, $nonce, self::key($token)));
    }

    /** Null where the token is another one. */
    public static function open(string $sealed, string $token): ?string
    {
        $bytes = (string) base64_decode($sealed, true);
        if (strlen($bytes) < SODIUM_CRYPTO_SECRETBOX_NONCEBYTES + SODIUM_CRYPTO_SECRETBOX_MACBYTES) {
            return null;
        }
        $text = sodium_crypto_secretbox_open(
            substr($bytes, SODIUM_CRYPTO_SECRETBOX_NONCEBYTES),
            substr($bytes, 0, SODIUM_CRYPTO_SECRETBOX_NONCEBYTES),
            self::key($token),
        );
        return $text === false ? null : $text;
    }

    private static function key(string $token): string
    {
        return hash('sha256', $token, true);
    }
}
