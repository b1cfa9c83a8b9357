<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

/** An operation that may be called, as the WSDL has it. */
final readonly class Operation
{
    /**
     * @param array<string, string> $parameters name to type, marked as Type says
     * @param ?string $answer type of what it answers; null: nothing
     */
    public function __construct(
        public string $name,
        public string $service,
        public array $parameters,
        public ?string $answer,
    ) {
    }
}
