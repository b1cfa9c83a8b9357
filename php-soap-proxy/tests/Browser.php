<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

/** Keeps a cookie and sends a token, as a browser with the page does. */
final class Browser
{
    public string $token = '';
    private string $cookie = '';

    public function __construct(private readonly string $address)
    {
    }

    /** @param array<string, mixed>|null $body @return array{status: int, type: string, json: mixed} */
    public function ask(string $method, string $path, ?array $body = null): array
    {
        $headers = ["X-Dronemap-Token: $this->token", "Cookie: $this->cookie"];
        if ($body !== null) {
            $headers[] = 'Content-Type: application/json';
        }
        $answer = file_get_contents("$this->address/$path", false, stream_context_create(['http' => [
            'method' => $method,
            'header' => implode("\r\n", $headers),
            'content' => $body === null ? '' : json_encode((object) $body),
            'ignore_errors' => true,
            'timeout' => 60,
        ]]));
        $type = '';
        foreach ($http_response_header as $header) {
            if (preg_match('/^Set-Cookie: ([^;]*)/i', $header, $found) === 1) {
                $this->cookie = $found[1];
            } elseif (preg_match('/^Content-Type: (.*)/i', $header, $found) === 1) {
                $type = $found[1];
            }
        }
        preg_match('/^HTTP\S+ (\d+)/', $http_response_header[0], $status);
        return ['status' => (int) $status[1], 'type' => $type, 'json' => json_decode((string) $answer)];
    }

    /** @param array<string, string> $proof @return array{status: int, type: string, json: mixed} */
    public function signIn(array $proof): array
    {
        $answer = $this->ask('POST', 'session.php', $proof);
        $this->token = $answer['json']->token ?? '';
        return $answer;
    }

    /** @param array<string, mixed> $body @return array{status: int, type: string, json: mixed} */
    public function call(string $operation, array $body = []): array
    {
        return $this->ask('POST', "proxy.php?operation=$operation", $body);
    }

    public function forgetCookie(): void
    {
        $this->cookie = '';
    }
}
