<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

use Dronemap\SoapProxy\Problem;

/**
 * What may be called, and of which types it all is: the file contract.php, which bin/write-contract.php makes of the
 * WSDL.
 */
final readonly class Contract
{
    /**
     * @param array<string, array{service: string, parameters: array<string, string>, answer: ?string}> $operations
     * @param array<string, array<string, string>> $types members of each type, written like parameters
     * @param array<string, string> $leftOut why an operation of the services is not here
     */
    public function __construct(public array $operations, public array $types, public array $leftOut)
    {
    }

    public static function written(): self
    {
        return new self(...require __DIR__ . '/contract.php');
    }

    public function operation(string $name): Operation
    {
        $found = $this->operations[$name] ?? null;
        if ($found !== null) {
            return new Operation($name, $found['service'], $found['parameters'], $found['answer']);
        }
        $why = $this->leftOut[$name] ?? 'There is no such operation.';
        throw Problem::own(
            404,
            'unknown',
            'proxy-operation-unknown',
            'There is no such thing',
            "This proxy has no operation '$name'. $why",
        );
    }

    /** @return ?array<string, string> members of a type; null where it is a plain one */
    public function members(string $type): ?array
    {
        return $this->types[$type] ?? null;
    }
}
