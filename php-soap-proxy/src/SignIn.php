<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy;

use Dronemap\SoapProxy\Contract\Operation;
use Dronemap\SoapProxy\Http\Request;
use Dronemap\SoapProxy\Http\Response;
use Dronemap\SoapProxy\Session\HeldSession;
use Dronemap\SoapProxy\Session\Sessions;
use Dronemap\SoapProxy\Soap\Credential;
use Dronemap\SoapProxy\Soap\SoapServer;
use stdClass;

/**
 * Signing in and out. By name and password the server is asked once, for an access key of the session's own, which
 * cannot administer anything and is deleted at its end; the password is kept nowhere.
 */
final readonly class SignIn
{
    private const LABEL = 'PHP page';
    private const DAYS = 1;

    public function __construct(private Sessions $sessions, private SoapServer $server)
    {
    }

    public function answer(Request $request): Response
    {
        return match ($request->method) {
            'GET' => self::told($this->sessions->held($request)),
            'POST' => $this->begin($request),
            'DELETE' => $this->end($request),
            default => throw Problem::own(
                405,
                'method',
                'method-not-taken',
                'Not that method',
                'Sign in by POST, out by DELETE; GET tells who is signed in.',
            ),
        };
    }

    private static function told(HeldSession $session): Response
    {
        return Response::json(['user' => $session->user, 'expires' => gmdate('Y-m-d\TH:i:s\Z', $session->ends)]);
    }

    private function begin(Request $request): Response
    {
        $given = $request->json();
        $token = isset($given->key)
            ? $this->byKey(self::text($given, 'key'), $request->time)
            : $this->byPassword(self::text($given, 'user'), self::text($given, 'password'), $request->time);
        return Response::json([
            'token' => $token,
            'user' => isset($given->key) ? null : $given->user,
            'expires' => gmdate('Y-m-d\TH:i:s\Z', $request->time + Sessions::MOST_SECONDS),
        ]);
    }

    private function byKey(string $key, int $now): string
    {
        $looks = new Operation('getSettings', 'ServerService', [], null);
        $this->server->call($looks, [], Credential::key($key));
        return $this->sessions->begin($key, null, null, $now);
    }

    private function byPassword(string $name, string $password, int $now): string
    {
        $asks = new Operation('makeAccessKey', 'AccountService', [], null);
        $made = $this->server->call($asks, [
            'label' => self::LABEL,
            'operations' => ['item' => ['view', 'plan', 'command']],
            'days' => self::DAYS,
        ], Credential::password($name, $password));
        return $this->sessions->begin($made->key, $made->id, $name, $now);
    }

    private function end(Request $request): Response
    {
        $session = $this->sessions->held($request);
        try {
            if ($session->keyId !== null) {
                $deletes = new Operation('deleteAccessKey', 'AccountService', [], null);
                $this->server->call($deletes, ['accessKeyId' => $session->keyId], Credential::key($session->key));
            }
        } finally {
            // Without the server, too: then the key ends by itself within a day.
            $this->sessions->end();
        }
        return Response::nothing();
    }

    private static function text(stdClass $given, string $name): string
    {
        $value = $given->{$name} ?? null;
        if (!is_string($value) || $value === '') {
            $detail = 'Send "user" and "password", or "key", each a text.';
            throw Problem::value('value-missing', $name, $detail, 'a text');
        }
        return $value;
    }
}
