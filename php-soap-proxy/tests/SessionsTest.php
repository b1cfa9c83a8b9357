<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Session\Sessions;
use PHPUnit\Framework\TestCase;

final class SessionsTest extends TestCase
{
    private MemorySessionStore $store;
    private Sessions $sessions;

    protected function setUp(): void
    {
        $this->store = new MemorySessionStore();
        $this->sessions = new Sessions($this->store);
    }

    public function testTokenOpensTheSession(): void
    {
        $token = $this->sessions->begin('the-key', 'key-id', 'ann', Requests::NOW);
        $held = $this->sessions->held(Requests::get([], ['x-dronemap-token' => $token]));
        self::assertSame(['the-key', 'key-id', 'ann'], [$held->key, $held->keyId, $held->user]);
        self::assertSame(Requests::NOW + Sessions::MOST_SECONDS, $held->ends);
    }

    public function testWhatIsKeptDoesNotHaveTheKey(): void
    {
        $token = $this->sessions->begin('the-key', null, null, Requests::NOW);
        $kept = serialize($this->store->values);
        self::assertStringNotContainsString('the-key', $kept);
        self::assertStringNotContainsString(base64_encode('the-key'), $kept);
        self::assertStringNotContainsString($token, $kept);
    }

    /** @dataProvider wrongTokens */
    public function testCookieWithoutTheTokenIsOfNoUse(string $token): void
    {
        $this->sessions->begin('the-key', null, null, Requests::NOW);
        $asks = Requests::get([], $token === '' ? [] : ['x-dronemap-token' => $token]);
        $problem = Problems::of(fn () => $this->sessions->held($asks));
        self::assertSame([403, 'proxy-token-wrong'], [$problem->status(), $problem->members['code']]);
    }

    /** @return array<string, array{string}> */
    public function wrongTokens(): array
    {
        return ['none' => [''], 'another' => [str_repeat('a', 64)], 'short' => ['x']];
    }

    public function testNobodyIsSignedInWithoutASession(): void
    {
        $problem = Problems::of(fn () => $this->sessions->held(Requests::get()));
        self::assertSame([401, 'proxy-signed-out'], [$problem->status(), $problem->members['code']]);
    }

    public function testUnusedSessionEnds(): void
    {
        $headers = ['x-dronemap-token' => $this->sessions->begin('k', null, null, Requests::NOW)];
        $last = Requests::NOW + Sessions::IDLE_SECONDS - 1;
        $this->sessions->held(Requests::get([], $headers, $last));
        self::assertSame($last, $this->store->values['seen']);
        $late = $last + Sessions::IDLE_SECONDS;
        $problem = Problems::of(fn () => $this->sessions->held(Requests::get([], $headers, $late)));
        self::assertSame('proxy-signed-out', $problem->members['code']);
    }

    public function testUsedSessionEndsAsWell(): void
    {
        $headers = ['x-dronemap-token' => $this->sessions->begin('k', null, null, Requests::NOW)];
        $end = Requests::NOW + Sessions::MOST_SECONDS;
        for ($time = Requests::NOW; $time < $end; $time += 1000) {
            $this->sessions->held(Requests::get([], $headers, $time));
        }
        $problem = Problems::of(fn () => $this->sessions->held(Requests::get([], $headers, $end)));
        self::assertSame('proxy-signed-out', $problem->members['code']);
    }

    public function testUseIsNotedOnceAMinute(): void
    {
        $headers = ['x-dronemap-token' => $this->sessions->begin('k', null, null, Requests::NOW)];
        for ($second = 0; $second < 120; $second++) {
            $this->sessions->held(Requests::get([], $headers, Requests::NOW + $second));
        }
        self::assertSame(1, $this->store->kept);
    }
}
