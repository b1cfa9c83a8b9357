<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Http\OtherSites;
use PHPUnit\Framework\TestCase;

final class OtherSitesTest extends TestCase
{
    /**
     * @dataProvider ownRequests
     * @param array<string, string> $headers
     */
    public function testOwnPageMayAsk(array $headers): void
    {
        (new OtherSites())->refuse(Requests::get([], $headers));
        $this->addToAssertionCount(1);
    }

    /** @return array<string, array{array<string, string>}> */
    public function ownRequests(): array
    {
        return [
            'a program without a browser' => [[]],
            'the page' => [['sec-fetch-site' => 'same-origin']],
            'the page, by POST' => [['sec-fetch-site' => 'same-origin', 'origin' => 'http://page.test']],
            'behind a server that ends TLS' => [['origin' => 'https://page.test']],
            'with a port' => [['origin' => 'http://page.test:8083', 'host' => 'page.test:8083']],
        ];
    }

    /**
     * @dataProvider othersRequests
     * @param array<string, string> $headers
     */
    public function testOtherSitesMayNot(array $headers): void
    {
        $problem = Problems::of(fn () => (new OtherSites())->refuse(Requests::get([], $headers)));
        self::assertSame([403, 'proxy-other-site'], [$problem->status(), $problem->members['code']]);
    }

    /** @return array<string, array{array<string, string>}> */
    public function othersRequests(): array
    {
        return [
            'another site' => [['sec-fetch-site' => 'cross-site']],
            'another host of the same site' => [['sec-fetch-site' => 'same-site']],
            'typed as an address' => [['sec-fetch-site' => 'none']],
            'another origin' => [['origin' => 'http://other.test']],
            'another port' => [['origin' => 'http://page.test:1', 'host' => 'page.test:2']],
            'no origin that can be told' => [['origin' => 'null']],
            'a name that begins alike' => [['origin' => 'http://page.test.other.test']],
        ];
    }
}
