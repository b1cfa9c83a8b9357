<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Contract\Contract;
use Dronemap\SoapProxy\Contract\WsdlReader;
use PHPUnit\Framework\TestCase;

final class ContractTest extends TestCase
{
    private const FOLDER = __DIR__ . '/../../dronemap-ws/src/test/resources/wire/wsdl';

    public function testEachOperationIsServedOrLeftOutForAReason(): void
    {
        $contract = Contract::written();
        $files = glob(self::FOLDER . '/*.wsdl');
        self::assertNotEmpty($files);
        $all = [];
        foreach ($files as $file) {
            foreach (WsdlReader::ofFile($file)->operations() as $name) {
                $all[$name] = true;
                $served = isset($contract->operations[$name]);
                $leftOut = isset($contract->leftOut[$name]);
                self::assertTrue($served !== $leftOut, "$name is neither served nor left out, or both.");
            }
        }
        self::assertGreaterThan(100, count($contract->operations));
        self::assertEquals(count($all), count($contract->operations) + count($contract->leftOut));
    }

    public function testNothingThatMakesRightsIsServed(): void
    {
        foreach (['makeAccessKey', 'addUser', 'addGrant', 'resetPassword', 'makeLinkKey', 'makeBackup'] as $name) {
            $problem = Problems::of(static fn () => Contract::written()->operation($name));
            self::assertSame([404, 'proxy-operation-unknown'], [$problem->status(), $problem->members['code']]);
        }
    }

    public function testNamesThatAreNoneAreRefused(): void
    {
        foreach (['', '__doRequest', 'Arm', 'arm ', '../arm'] as $name) {
            $problem = Problems::of(static fn () => Contract::written()->operation($name));
            self::assertSame('proxy-operation-unknown', $problem->members['code']);
        }
    }
}
