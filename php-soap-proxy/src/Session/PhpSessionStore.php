<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Session;

use RuntimeException;

/** PHP's own sessions. None stays open during a call: another one of the same browser would wait for it. */
final readonly class PhpSessionStore implements SessionStore
{
    public const COOKIE = 'dronemap-php';

    /** @param ?string $folder null: where php.ini says */
    public function __construct(private ?string $folder, private bool $secure)
    {
    }

    public function read(): array
    {
        if (!isset($_COOKIE[self::COOKIE])) {
            return [];
        }
        $this->start(['read_and_close' => true]);
        if ($_SESSION === []) {
            // PHP has begun a new one under another name; nobody needs it.
            session_start();
            session_destroy();
            header_remove('Set-Cookie');
        }
        return $_SESSION;
    }

    public function begin(array $values): void
    {
        $this->start([]);
        session_regenerate_id(true);
        $_SESSION = $values;
        session_write_close();
    }

    public function keep(array $values): void
    {
        $this->start([]);
        if ($_SESSION === []) {
            // It has been ended meanwhile; nothing may bring it back.
            session_destroy();
            return;
        }
        $_SESSION = $values;
        session_write_close();
    }

    public function end(): void
    {
        $this->start([]);
        $_SESSION = [];
        session_destroy();
        setcookie(self::COOKIE, '', ['expires' => 1] + $this->cookie());
    }

    /** @param array<string, mixed> $options */
    private function start(array $options): void
    {
        session_set_cookie_params($this->cookie());
        $kept = $this->folder === null ? [] : ['save_path' => $this->madeFolder($this->folder), 'gc_probability' => 1];
        $started = session_start($options + $kept + [
            'name' => self::COOKIE,
            'use_strict_mode' => true,
            'use_only_cookies' => true,
            'cache_limiter' => '',
            'gc_maxlifetime' => Sessions::IDLE_SECONDS,
        ]);
        if (!$started) {
            throw new RuntimeException('PHP could not start a session; see its log.');
        }
    }

    private function madeFolder(string $folder): string
    {
        if (!is_dir($folder) && !mkdir($folder, 0700, true) && !is_dir($folder)) {
            throw new RuntimeException("The folder $folder for sessions could not be made.");
        }
        return $folder;
    }

    /** @return array{path: string, secure: bool, httponly: bool, samesite: 'Strict'} */
    private function cookie(): array
    {
        // The folder of the page, so that other programs of the same web server do not get it.
        $path = rtrim(strtr(dirname((string) $_SERVER['SCRIPT_NAME']), '\\', '/'), '/') . '/';
        return ['path' => $path, 'secure' => $this->secure, 'httponly' => true, 'samesite' => 'Strict'];
    }
}
