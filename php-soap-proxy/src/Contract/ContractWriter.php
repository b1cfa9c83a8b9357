<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

/** Makes contract.php: which operations this proxy has, with all their types, and why it has no others. */
final class ContractWriter
{
    /** Services of which this proxy has every operation; where two have the same one, the first is asked. */
    private const SERVED = [
        'MAVLinkControllerService', 'PlanningService', 'VirtualDroneService', 'ApplicationWS', 'FollowerService',
        'DispatchService', 'RecoveryService',
    ];
    /** Why it has none of the other services. */
    private const LEFT_OUT = [
        'AccountService' => 'Accounts, keys and grants are managed on the ground station\'s page: what this proxy holds'
            . ' must not be able to make rights.',
        'FleetService' => 'Links, fleets and keys of vehicles are administration; use the ground station\'s page.',
        'RecordService' => 'Recordings, flights and the audit are files and long lists; REST has them without SOAP\'s'
            . ' bound of 4 MB.',
        'ServerService' => 'What concerns the server itself is for those who run it; use REST.',
    ];

    private const HEAD = <<<'PHP'
        <?php

        // Written by bin/write-contract.php from the WSDL. Do not edit.

        declare(strict_types=1);

        return [

        PHP;

    /** @var array<string, string> lines of types that have been written, by name */
    private array $types = [];
    /** @var array<string, string> */
    private array $operations = [];
    /** @var array<string, string> */
    private array $leftOut = [];

    /** @param string $folder with a WSDL for each service */
    public function write(string $folder): string
    {
        foreach (self::SERVED as $service) {
            $this->serve($service, WsdlReader::ofFile("$folder/$service.wsdl"));
        }
        foreach (self::LEFT_OUT as $service => $why) {
            foreach (WsdlReader::ofFile("$folder/$service.wsdl")->operations() as $name) {
                $this->leftOut[$name] = self::quoted($name) . ' => ' . self::quoted($why);
            }
        }
        $text = self::HEAD;
        foreach (['operations', 'types', 'leftOut'] as $part) {
            ksort($this->{$part});
            $text .= "    '$part' => [\n        " . implode(",\n        ", $this->{$part}) . ",\n    ],\n";
        }
        return "$text];\n";
    }

    private function serve(string $service, WsdlReader $wsdl): void
    {
        foreach ($wsdl->operations() as $name) {
            if (isset($this->operations[$name])) {
                continue;
            }
            $parameters = $wsdl->parameters($name);
            $answer = $wsdl->answer($name);
            $this->operations[$name] = sprintf(
                "%s => ['service' => %s, 'answer' => %s, 'parameters' => %s]",
                self::quoted($name),
                self::quoted($service),
                $answer === null ? 'null' : self::quoted($answer),
                self::listed($parameters),
            );
            $this->typesOf([...array_values($parameters), ...($answer === null ? [] : [$answer])], $wsdl);
        }
    }

    /** @param list<string> $types */
    private function typesOf(array $types, WsdlReader $wsdl): void
    {
        foreach ($types as $type) {
            $name = (string) preg_replace('/^(list of |map of )+/', '', Type::bare($type));
            if (!isset($this->types[$name]) && $wsdl->hasType($name)) {
                $members = $wsdl->type($name);
                $this->types[$name] = self::quoted($name) . ' => ' . self::listed($members);
                $this->typesOf(array_values($members), $wsdl);
            }
        }
    }

    /** @param array<string, string> $members */
    private static function listed(array $members): string
    {
        $texts = [];
        foreach ($members as $name => $type) {
            $texts[] = self::quoted($name) . ' => ' . self::quoted($type);
        }
        return '[' . implode(', ', $texts) . ']';
    }

    private static function quoted(string $text): string
    {
        return var_export($text, true);
    }
}
