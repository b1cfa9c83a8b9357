<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy;

use Closure;
use Dronemap\SoapProxy\Contract\Contract;
use Dronemap\SoapProxy\Http\OtherSites;
use Dronemap\SoapProxy\Http\Request;
use Dronemap\SoapProxy\Http\Response;
use Dronemap\SoapProxy\Session\PhpSessionStore;
use Dronemap\SoapProxy\Session\Sessions;
use Dronemap\SoapProxy\Soap\SoapServer;
use Throwable;

/** What the two programs of the page, proxy.php and session.php, have in common. */
final readonly class Page
{
    public static function proxy(): void
    {
        self::answer(static fn (Sessions $sessions, SoapServer $server, Request $request): Response =>
            (new Proxy(Contract::written(), $sessions, $server))->answer($request));
    }

    public static function session(): void
    {
        self::answer(static fn (Sessions $sessions, SoapServer $server, Request $request): Response =>
            (new SignIn($sessions, $server))->answer($request));
    }

    /** What Debian has in packages of their own, or another system may have left out. */
    private const EXTENSIONS = [
        'soap' => 'php-soap', 'dom' => 'php-xml', 'sodium' => 'php-common', 'session' => 'php-common',
    ];

    /** @param Closure(Sessions, SoapServer, Request): Response $handler */
    private static function answer(Closure $handler): void
    {
        // Warnings would end up in the middle of JSON; php.ini says where they are logged.
        ini_set('display_errors', '0');
        try {
            self::requireExtensions();
            $settings = Settings::ofEnvironment();
            $request = Request::received();
            (new OtherSites())->refuse($request);
            $sessions = new Sessions(new PhpSessionStore($settings->sessions, $request->secure));
            $handler($sessions, new SoapServer($settings), $request)->send();
        } catch (Problem $problem) {
            Response::problem($problem)->send();
        } catch (Throwable $fault) {
            error_log((string) $fault);
            $detail = 'The proxy failed; its log says why. Whether the request was carried out is not known.';
            Response::problem(Problem::own(500, 'failed', 'proxy-failed', 'The proxy failed', $detail))->send();
        }
    }

    private static function requireExtensions(): void
    {
        foreach (self::EXTENSIONS as $extension => $package) {
            if (!extension_loaded($extension)) {
                $detail = "PHP lacks its extension '$extension' here; nothing was done. Debian has it in $package.";
                throw Problem::own(500, 'failed', 'proxy-extension-missing', 'The proxy cannot work', $detail);
            }
        }
    }
}
