<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use PHPUnit\Framework\TestCase;

final class RequestTest extends TestCase
{
    /** @dataProvider unreadable */
    public function testOtherBodiesAreRefused(string $body, string $type, int $status, string $code): void
    {
        $problem = Problems::of(static fn () => Requests::post($body, ['content-type' => $type])->json());
        self::assertSame([$status, $code], [$problem->status(), $problem->members['code']]);
    }

    /** @return array<string, array{string, string, int, string}> */
    public function unreadable(): array
    {
        return [
            // What a form of another site can send without being asked.
            'a form' => ['{}', 'text/plain', 415, 'content-type-not-taken'],
            'a form with fields' => ['a=b', 'application/x-www-form-urlencoded', 415, 'content-type-not-taken'],
            'no JSON' => ['{', 'application/json', 400, 'json-unreadable'],
            'a list' => ['[]', 'application/json', 400, 'body-not-an-object'],
            'too long' => ['{"a":"' . str_repeat('x', 1_000_000) . '"}', 'application/json', 413, 'body-too-large'],
        ];
    }

    public function testJsonIsRead(): void
    {
        $json = Requests::post('{"a":1}', ['content-type' => 'application/json; charset=utf-8'])->json();
        self::assertSame(1, $json->a);
    }
}
