<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Settings;
use InvalidArgumentException;
use PHPUnit\Framework\TestCase;

final class SettingsTest extends TestCase
{
    public function testSettingsHaveDefaults(): void
    {
        $settings = Settings::from(['DRONEMAP_PHP_SERVER' => 'https://drones.test/']);
        self::assertSame(['https://drones.test', 15, null], [
            $settings->server, $settings->patienceSeconds, $settings->sessions,
        ]);
    }

    /** @dataProvider wrong */
    public function testWrongSettingIsToldByName(string $name, string $value): void
    {
        $this->expectException(InvalidArgumentException::class);
        $this->expectExceptionMessageMatches("/^$name is /");
        Settings::from([$name => $value]);
    }

    /** @return array<string, array{string, string}> */
    public function wrong(): array
    {
        return [
            'no address' => ['DRONEMAP_PHP_SERVER', 'localhost'],
            'a file' => ['DRONEMAP_PHP_SERVER', 'file:///etc/passwd'],
            'with a path' => ['DRONEMAP_PHP_SERVER', 'http://a/b'],
            'no number' => ['DRONEMAP_PHP_PATIENCE', 'long'],
            'too long' => ['DRONEMAP_PHP_PATIENCE', '601'],
        ];
    }
}
