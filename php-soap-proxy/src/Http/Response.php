<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Http;

use Dronemap\SoapProxy\Problem;

/** What a browser is answered. */
final readonly class Response
{
    private const FORM = JSON_UNESCAPED_SLASHES | JSON_UNESCAPED_UNICODE | JSON_THROW_ON_ERROR;

    private function __construct(public int $status, public string $type, public string $body)
    {
    }

    public static function json(mixed $value): self
    {
        return new self(200, 'application/json', json_encode($value, self::FORM));
    }

    public static function nothing(): self
    {
        return new self(204, '', '');
    }

    public static function problem(Problem $problem): self
    {
        return new self($problem->status(), 'application/problem+json', json_encode($problem->members, self::FORM));
    }

    public function send(): void
    {
        http_response_code($this->status);
        header_remove('X-Powered-By');
        header('Cache-Control: no-store');
        header('X-Content-Type-Options: nosniff');
        header('Cross-Origin-Resource-Policy: same-origin');
        header("Content-Security-Policy: default-src 'none'; frame-ancestors 'none'");
        if ($this->type !== '') {
            header("Content-Type: $this->type");
            echo $this->body;
        }
    }
}
