<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Http;

use Dronemap\SoapProxy\Problem;

/**
 * Keeps pages of other sites out. A browser says by itself where a request comes from (Origin, Sec-Fetch-Site);
 * no answer has a header that would allow another site to read it.
 */
final readonly class OtherSites
{
    public function refuse(Request $request): void
    {
        $site = $request->header('sec-fetch-site');
        $origin = $request->header('origin');
        if (!in_array($site, ['', 'same-origin'], true) || ($origin !== '' && !$this->isOwn($origin, $request))) {
            throw Problem::own(
                403,
                'forbidden',
                'proxy-other-site',
                'Another site',
                'Only the page of this proxy may ask it; this request comes from another site.',
            );
        }
    }

    /** Schemes are not compared: behind a server that ends TLS, this program sees another one than the browser. */
    private function isOwn(string $origin, Request $request): bool
    {
        $parts = parse_url($origin);
        if (!is_array($parts) || !isset($parts['host'])) {
            return false;
        }
        $port = isset($parts['port']) ? ':' . $parts['port'] : '';
        return strcasecmp($parts['host'] . $port, $request->header('host')) === 0;
    }
}
