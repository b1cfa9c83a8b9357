<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Session;

use Dronemap\SoapProxy\Http\Request;
use Dronemap\SoapProxy\Problem;

/** Who is signed in at this proxy: a cookie names the session, a token that only the page has opens it. */
final readonly class Sessions
{
    /** A session that nobody uses ends after so long. */
    public const IDLE_SECONDS = 1200;
    /** And each one after so long. */
    public const MOST_SECONDS = 43_200;
    private const NOTED_EACH_SECONDS = 60;

    public function __construct(private SessionStore $store)
    {
    }

    /** The token of a new session that holds this key. @param ?string $keyId of a key that was made for the session */
    public function begin(string $key, ?string $keyId, ?string $user, int $now): string
    {
        $token = Seal::newToken();
        $this->store->begin([
            'sealed' => Seal::close($key, $token),
            'keyId' => $keyId,
            'user' => $user,
            'began' => $now,
            'seen' => $now,
        ]);
        return $token;
    }

    /** The session of who asks; a problem where there is none, it is over, or the token is not its own. */
    public function held(Request $request): HeldSession
    {
        $values = $this->store->read();
        $now = $request->time;
        if ($values === [] || $now >= $this->ends($values)) {
            $detail = 'Sign in: there is no session, or it is over.';
            throw Problem::own(401, 'not-signed-in', 'proxy-signed-out', 'Not signed in', $detail);
        }
        $key = Seal::open((string) $values['sealed'], $request->header('x-dronemap-token'));
        if ($key === null) {
            throw Problem::own(
                403,
                'forbidden',
                'proxy-token-wrong',
                'Not this page',
                'The header X-Dronemap-Token is missing or belongs to another session: sign in again.',
            );
        }
        if ($now - $values['seen'] >= self::NOTED_EACH_SECONDS) {
            $this->store->keep(['seen' => $now] + $values);
        }
        return new HeldSession($key, $values['keyId'], $values['user'], $values['began'] + self::MOST_SECONDS);
    }

    public function end(): void
    {
        $this->store->end();
    }

    /** @param array<string, mixed> $values */
    private function ends(array $values): int
    {
        return min($values['began'] + self::MOST_SECONDS, $values['seen'] + self::IDLE_SECONDS);
    }
}
