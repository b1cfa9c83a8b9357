<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Http;

use Dronemap\SoapProxy\Problem;
use JsonException;
use stdClass;

/** One request of a browser. */
final readonly class Request
{
    private const MOST_BYTES = 1_000_000;

    /**
     * @param array<string, mixed> $query
     * @param array<string, string> $headers names in small letters
     */
    public function __construct(
        public string $method,
        public array $query,
        public array $headers,
        public string $body,
        /** Seconds since 1970. */
        public int $time,
        public bool $secure,
    ) {
    }

    public static function received(): self
    {
        $headers = [];
        foreach ($_SERVER as $name => $value) {
            if (str_starts_with($name, 'HTTP_') && is_string($value)) {
                $headers[strtolower(strtr(substr($name, 5), '_', '-'))] = $value;
            }
        }
        $headers['content-type'] = (string) ($_SERVER['CONTENT_TYPE'] ?? '');
        return new self(
            (string) $_SERVER['REQUEST_METHOD'],
            $_GET,
            $headers,
            (string) file_get_contents('php://input', length: self::MOST_BYTES + 1),
            (int) $_SERVER['REQUEST_TIME'],
            ($_SERVER['HTTPS'] ?? 'off') !== 'off' || ($headers['x-forwarded-proto'] ?? '') === 'https',
        );
    }

    public function header(string $name): string
    {
        return $this->headers[$name] ?? '';
    }

    /** The body as an object of JSON. */
    public function json(): stdClass
    {
        if (strlen($this->body) > self::MOST_BYTES) {
            $detail = 'The body of this request may have at most 1 MB.';
            throw Problem::own(413, 'too-large', 'body-too-large', 'Too much', $detail);
        }
        if (strtolower(trim(explode(';', $this->header('content-type'))[0])) !== 'application/json') {
            $detail = 'The body must be application/json; say so in Content-Type.';
            throw Problem::own(415, 'media-type', 'content-type-not-taken', 'Not that kind of content', $detail);
        }
        try {
            $json = json_decode($this->body, flags: JSON_THROW_ON_ERROR);
        } catch (JsonException $unreadable) {
            $detail = 'This is not JSON: ' . $unreadable->getMessage() . '.';
            throw Problem::own(400, 'malformed', 'json-unreadable', 'It cannot be read', $detail);
        }
        if (!$json instanceof stdClass) {
            $detail = 'A JSON object is needed as the body of this request.';
            throw Problem::own(400, 'malformed', 'body-not-an-object', 'It cannot be read', $detail);
        }
        return $json;
    }
}
