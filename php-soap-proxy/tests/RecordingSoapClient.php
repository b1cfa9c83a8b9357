<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Tests;

use SoapClient;
use SoapFault;

/** Writes messages and sends none. */
final class RecordingSoapClient extends SoapClient
{
    private string $request = '';

    public function __construct(string $wsdl)
    {
        parent::__construct($wsdl, ['cache_wsdl' => WSDL_CACHE_NONE]);
    }

    /** @param array<string, mixed> $arguments */
    public function written(string $operation, array $arguments): string
    {
        try {
            $this->__soapCall($operation, [$arguments]);
        } catch (SoapFault $fault) {
            // There is no answer; but what cannot be written is a fault of its own.
            if (str_contains($fault->getMessage(), 'Encoding')) {
                throw $fault;
            }
        }
        return $this->request;
    }

    public function __doRequest(
        string $request,
        string $location,
        string $action,
        int $version,
        bool $oneWay = false
    ): ?string {
        $this->request = $request;
        return '';
    }
}
