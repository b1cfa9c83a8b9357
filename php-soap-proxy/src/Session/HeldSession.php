<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Session;

/** A session that has been opened with its token. */
final readonly class HeldSession
{
    public function __construct(
        public string $key,
        /** The id of a key that was made for this session, and goes with it; null: the user brought a key. */
        public ?string $keyId,
        public ?string $user,
        /** Seconds since 1970. */
        public int $ends,
    ) {
    }
}
