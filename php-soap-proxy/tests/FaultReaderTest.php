<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use Dronemap\SoapProxy\Soap\FaultReader;
use PHPUnit\Framework\TestCase;
use SoapFault;

final class FaultReaderTest extends TestCase
{
    private const FAULT = <<<'XML'
        <s:Envelope xmlns:s="http://schemas.xmlsoap.org/soap/envelope/"><s:Body><s:Fault>
        <faultcode>s:Client</faultcode><faultstring>Too high.</faultstring><detail>
        <n:DronemapFault xmlns:n="http://cloud.dronemap.org/wsdl"><type>urn:dronemap:problem:invalid-value</type>
        <title>T</title><status>422</status><detail>Too high.</detail><code>value-out-of-range</code>
        <parameters><entry key="most" type="number">120</entry>
        <entry key="field" type="string">altitude</entry></parameters>
        <field>altitude</field></n:DronemapFault></detail></s:Fault></s:Body></s:Envelope>
        XML;

    public function testFaultOfTheServerIsItsProblem(): void
    {
        $problem = FaultReader::problem(new SoapFault('s:Client', 'Too high.'), self::FAULT, true, 'http://server');
        self::assertSame(422, $problem->status());
        self::assertSame('Too high.', $problem->getMessage());
        self::assertEquals(['most' => 120, 'field' => 'altitude'], (array) $problem->members['parameters']);
        self::assertSame('altitude', $problem->members['field']);
    }

    public function testProblemBeforeAnySoapIsTakenAsItIs(): void
    {
        $json = '{"type":"t","title":"T","status":429,"detail":"Slower.","code":"too-many","retryAfterSeconds":3}';
        $problem = FaultReader::problem(new SoapFault('Client', 'no XML document'), $json, true, 'http://server');
        self::assertSame([429, 'Slower.', 3], [
            $problem->status(), $problem->getMessage(), $problem->members['retryAfterSeconds'],
        ]);
    }

    /** @dataProvider onTheWay */
    public function testWhatBecameOfTheCallIsTold(string $reason, ?string $message, bool $sent, string $code): void
    {
        $problem = FaultReader::problem(new SoapFault('HTTP', $reason), $message, $sent, 'http://server');
        self::assertSame($code, $problem->members['code']);
        $unknown = str_contains($problem->getMessage(), 'is not known');
        self::assertSame($code === 'proxy-server-timeout', $unknown);
    }

    /** @return array<string, array{string, ?string, bool, string}> */
    public function onTheWay(): array
    {
        return [
            'no connection' => ['Could not connect to host', null, true, 'proxy-server-unreachable'],
            'no description' => ['SOAP-ERROR: Parsing WSDL', null, false, 'proxy-server-unreachable'],
            'no answer' => ['Error Fetching http headers', null, true, 'proxy-server-timeout'],
            'half an answer' => ['Error Fetching http body', '<s:Envel', true, 'proxy-server-timeout'],
            'something else' => ['looks like we got no XML document', '<html>', true, 'proxy-server-timeout'],
            'unfit value' => ['SOAP-ERROR: Encoding: violation', null, true, 'value-malformed'],
        ];
    }
}
