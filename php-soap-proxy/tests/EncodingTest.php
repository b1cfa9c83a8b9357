<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use DOMDocument;
use DOMElement;
use Dronemap\SoapProxy\Contract\ArgumentReader;
use Dronemap\SoapProxy\Contract\Contract;
use Dronemap\SoapProxy\Contract\Type;
use PHPUnit\Framework\TestCase;

/** What PHP's SoapClient makes of arguments is held against the schemas of the recorded WSDL, by libxml. */
final class EncodingTest extends TestCase
{
    private const FOLDER = __DIR__ . '/../../dronemap-ws/src/test/resources/wire/wsdl';
    private const TYPES = 'http://cloud.dronemap.org/types/2';
    private const SAMPLES = [
        'string' => 'a < b & "c"', 'dateTime' => '2026-01-02T03:04:05Z', 'base64Binary' => 'AP8=', 'boolean' => true,
        'int' => 7, 'long' => 4_000_000_000, 'double' => 1.5,
    ];

    private string $schemas;

    protected function setUp(): void
    {
        $this->schemas = sys_get_temp_dir() . '/dronemap-schemas-' . bin2hex(random_bytes(6));
        mkdir($this->schemas, 0700);
    }

    protected function tearDown(): void
    {
        array_map('unlink', (array) glob("$this->schemas/*"));
        rmdir($this->schemas);
    }

    /** @dataProvider services */
    public function testEachOperationOfTheServiceIsWrittenAsTheSchemaWants(string $service): void
    {
        $contract = Contract::written();
        $client = new RecordingSoapClient(self::FOLDER . "/$service.wsdl");
        $schema = $this->schemaOf($service);
        foreach ($contract->operations as $name => $described) {
            if ($described['service'] !== $service) {
                continue;
            }
            $filled = self::filled($described['parameters'], $contract);
            $body = json_encode($filled);
            $reader = new ArgumentReader($contract);
            $arguments = $reader->read($contract->operation($name), Requests::post((string) $body));
            $written = $client->written($name, $arguments);
            self::assertSame([], $this->faults($written, $schema), "$name: $body");
            // A list that got lost would be one that is empty to the schema.
            self::assertSame(self::values($filled), preg_match_all('/>[^<>\s][^<>]*</', $written), "$name: $body");
        }
    }

    /** @return array<string, array{string}> */
    public function services(): array
    {
        $services = array_unique(array_column(Contract::written()->operations, 'service'));
        return array_combine($services, array_map(static fn (string $service): array => [$service], $services));
    }

    /** @param array<string, string> $members @return array<string, mixed> */
    private static function filled(array $members, Contract $contract): object
    {
        $filled = [];
        foreach ($members as $name => $type) {
            $filled[$name] = self::sample(Type::bare($type), $contract);
        }
        return (object) $filled;
    }

    private static function values(mixed $filled): int
    {
        return is_array($filled) || is_object($filled)
            ? array_sum(array_map(self::values(...), (array) $filled))
            : 1;
    }

    private static function sample(string $type, Contract $contract): mixed
    {
        if (str_starts_with($type, 'list of ')) {
            return [self::sample(substr($type, 8), $contract), self::sample(substr($type, 8), $contract)];
        }
        $members = $contract->members($type);
        if ($members === null) {
            return self::SAMPLES[$type];
        }
        $isChoice = $members !== [] && array_filter($members, static fn (string $member): bool =>
            !str_ends_with($member, '?')) === [];
        return self::filled($isChoice ? array_slice($members, 0, 1) : $members, $contract);
    }

    /** The schemas within a WSDL as files, since libxml reads them only so. */
    private function schemaOf(string $service): string
    {
        $wsdl = new DOMDocument();
        $wsdl->load(self::FOLDER . "/$service.wsdl");
        foreach ($wsdl->getElementsByTagNameNS('http://www.w3.org/2001/XMLSchema', 'schema') as $schema) {
            assert($schema instanceof DOMElement);
            $isTypes = $schema->getAttribute('targetNamespace') === self::TYPES;
            $copy = new DOMDocument();
            $root = $copy->importNode($schema, true);
            assert($root instanceof DOMElement);
            $copy->appendChild($root);
            if (!$isTypes) {
                foreach (iterator_to_array($root->getElementsByTagNameNS('*', 'import')) as $import) {
                    $import->setAttribute('schemaLocation', 'types.xsd');
                }
            }
            $copy->save($this->schemas . ($isTypes ? '/types.xsd' : '/service.xsd'));
        }
        return "$this->schemas/service.xsd";
    }

    /** @return list<string> */
    private function faults(string $envelope, string $schema): array
    {
        $sent = new DOMDocument();
        $sent->loadXML($envelope);
        $body = $sent->getElementsByTagNameNS('*', 'Body')->item(0)?->firstChild;
        assert($body !== null);
        $message = new DOMDocument();
        $message->appendChild($message->importNode($body, true));
        // The elements bring their namespaces along only when they are read anew.
        $message->loadXML((string) $message->saveXML());
        libxml_use_internal_errors(true);
        $message->schemaValidate($schema);
        $faults = array_map(static fn ($fault): string => trim($fault->message), libxml_get_errors());
        libxml_clear_errors();
        libxml_use_internal_errors(false);
        // Which texts are allowed is the server's matter.
        return array_values(array_filter($faults, static fn (string $fault): bool =>
            !str_contains($fault, "'enumeration'") && !str_contains($fault, 'not a valid value of the local atomic')));
    }
}
