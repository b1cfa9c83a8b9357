<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Contract\ArgumentReader;
use Dronemap\SoapProxy\Contract\Contract;
use PHPUnit\Framework\TestCase;

final class ArgumentReaderTest extends TestCase
{
    /** @return array<string, mixed> */
    private static function read(string $operation, string $body): array
    {
        $contract = Contract::written();
        return (new ArgumentReader($contract))->read($contract->operation($operation), Requests::post($body));
    }

    /** @param array<string, string> $query @return array<string, mixed> */
    private static function readQuery(string $operation, array $query): array
    {
        $contract = Contract::written();
        $asks = Requests::get(['operation' => $operation] + $query);
        return (new ArgumentReader($contract))->read($contract->operation($operation), $asks);
    }

    public function testQueryBecomesWhatTheTypesSay(): void
    {
        $query = ['droneId' => '17', 'latitude' => '47.4', 'longitude' => '8', 'altitude' => '-1.5e1', 'epoch' => '7'];
        self::assertSame(
            ['droneId' => '17', 'latitude' => 47.4, 'longitude' => 8.0, 'altitude' => -15.0, 'epoch' => 7],
            self::readQuery('goto', $query),
        );
        self::assertSame(['active' => false], self::readQuery('getDronesList', ['active' => 'false']));
    }

    public function testListsGetTheElementsOfSoap(): void
    {
        $body = '{"droneId":"d","items":[{"waypoint":{"latitude":47,"longitude":8.5,"altitude":10}},{"land":{}}]}';
        self::assertSame(
            ['item' => [
                ['waypoint' => ['latitude' => 47, 'longitude' => 8.5, 'altitude' => 10]],
                ['land' => []],
            ]],
            self::read('uploadMission', $body)['items'],
        );
        self::assertSame(['item' => []], self::read('uploadMission', '{"droneId":"d","items":[]}')['items']);
    }

    public function testWhatIsMissingIsLeftToTheServer(): void
    {
        self::assertSame(['droneId' => 'd', 'altitude' => null], self::read('takeoff', '{"droneId":"d"}'));
    }

    /** @dataProvider refused */
    public function testOtherValuesAreRefusedByName(string $operation, string $body, string $field, string $says): void
    {
        $problem = Problems::of(fn () => self::read($operation, $body));
        self::assertSame([422, $field, $says], [
            $problem->status(), $problem->members['field'], $problem->getMessage(),
        ]);
    }

    /** @return array<string, array{string, string, string, string}> */
    public function refused(): array
    {
        return [
            'text for a number' => ['takeoff', '{"altitude":"8"}', 'altitude', '"altitude" must be a number.'],
            'part for a whole' => ['arm', '{"epoch":1.5}', 'epoch', '"epoch" must be a whole number.'],
            'number for a text' => ['arm', '{"droneId":5}', 'droneId', '"droneId" must be a text.'],
            'object for a list' => ['uploadMission', '{"items":{}}', 'items', '"items" must be a list.'],
            'text for an object' => [
                'uploadMission', '{"items":["land"]}', 'items[0]', '"items[0]" must be an object.',
            ],
            'within a list' => [
                'uploadMission',
                '{"items":[{"waypoint":{"latitude":"x"}}]}',
                'items[0].waypoint.latitude',
                '"items[0].waypoint.latitude" must be a number.',
            ],
            'unknown' => ['getDrone', '{"drone":"d"}', 'drone', 'There is no member "drone" here; there are: droneId.'],
        ];
    }

    public function testQueryCannotHaveLists(): void
    {
        $problem = Problems::of(fn () => self::readQuery('uploadMission', ['droneId' => 'd', 'items' => '[]']));
        self::assertSame('"items" must be sent in the body of a POST, as JSON.', $problem->getMessage());
    }
}
