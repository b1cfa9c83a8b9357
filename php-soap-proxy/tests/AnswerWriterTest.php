<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Contract\AnswerWriter;
use Dronemap\SoapProxy\Contract\Contract;
use PHPUnit\Framework\TestCase;

final class AnswerWriterTest extends TestCase
{
    private const TYPES = [
        'Fleet' => ['drones' => 'list of Drone', 'names' => 'list of string', 'path' => 'list of list of double'],
        'Drone' => ['id' => 'string', 'height' => 'double|null', 'photo' => 'base64Binary?', 'may' => 'map of Action'],
        'Action' => ['allowed' => 'boolean', 'why' => 'string|null'],
        'Told' => ['parameters' => 'map of plain'],
    ];

    private static function write(string $type, string $soap): string
    {
        $written = (new AnswerWriter(new Contract([], self::TYPES, [])))->write($type, json_decode($soap));
        return (string) json_encode($written);
    }

    public function testListsAreListsEvenWhenEmpty(): void
    {
        self::assertSame(
            '{"drones":[],"names":["a"],"path":[[8.5,47],[]]}',
            self::write('Fleet', '{"drones":{},"names":{"item":["a"]},"path":{"item":[{"item":[8.5,47]},{}]}}'),
        );
    }

    public function testWhatNobodyKnowsIsNull(): void
    {
        self::assertSame('{"id":"d","may":{},"height":null}', self::write('Drone', '{"id":"d","may":{}}'));
        self::assertSame('null', (string) json_encode((new AnswerWriter(Contract::written()))->write('Drones', null)));
    }

    public function testMapsAreObjects(): void
    {
        $soap = '{"id":"d","may":{"entry":[{"key":"arm","allowed":true},{"key":"land","allowed":false,"why":"no"}]}}';
        self::assertSame(
            '{"id":"d","may":{"arm":{"allowed":true,"why":null},"land":{"allowed":false,"why":"no"}},"height":null}',
            self::write('Drone', $soap),
        );
    }

    public function testEntriesOfPlainMapsAreOfTheTypeTheyName(): void
    {
        $soap = '{"parameters":{"entry":[{"key":"a","type":"number","_":"9"},{"key":"b","type":"number","_":"9.5"},'
            . '{"key":"c","type":"boolean","_":"true"},{"key":"d","type":"string","_":"9"}]}}';
        self::assertSame('{"parameters":{"a":9,"b":9.5,"c":true,"d":"9"}}', self::write('Told', $soap));
    }

    public function testBytesAreInBase64AndUnknownMembersAreLeftOut(): void
    {
        self::assertSame('{"photo":"AP8=","height":1.5}', self::bytes());
    }

    private static function bytes(): string
    {
        $soap = (object) ['photo' => "\x00\xff", 'height' => 1.5, 'newer' => 'than this'];
        return (string) json_encode((new AnswerWriter(new Contract([], self::TYPES, [])))->write('Drone', $soap));
    }
}
