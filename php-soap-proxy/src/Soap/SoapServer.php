<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Soap;

use Dronemap\SoapProxy\Contract\Operation;
use Dronemap\SoapProxy\Settings;
use SoapClient;
use SoapFault;

/** The services of the Dronemap server, called by the WSDL that it serves. */
final readonly class SoapServer
{
    private const CONNECT_SECONDS = 3;

    public function __construct(private Settings $settings)
    {
    }

    /** What it answers: the value of `return`, null where there is none. @param array<string, mixed> $arguments */
    public function call(Operation $operation, array $arguments, Credential $credential): mixed
    {
        $wait = is_numeric($arguments['wait'] ?? null) ? (int) ceil((float) $arguments['wait']) : 0;
        ini_set('default_socket_timeout', (string) ($this->settings->patienceSeconds + max(0, min($wait, 60))));
        $client = null;
        try {
            $client = $this->client($operation->service, $credential);
            $answer = $client->__soapCall($operation->name, [$arguments]);
        } catch (SoapFault $fault) {
            $message = $client?->__getLastResponse();
            throw FaultReader::problem($fault, $message, $client !== null, $this->settings->server);
        }
        return $answer->return ?? null;
    }

    private function client(string $service, Credential $credential): SoapClient
    {
        // A process of PHP serves many requests: it keeps what it has read of each service.
        ini_set('soap.wsdl_cache_limit', '20');
        ini_set('soap.wsdl_cache_ttl', '600');
        $address = $this->settings->server . "/services/$service";
        return new SoapClient("$address?wsdl", [
            // What the WSDL calls the server's address may be one that only browsers reach.
            'location' => $address,
            // In memory alone: whoever can write to the folder of the other cache could choose where calls go.
            'cache_wsdl' => WSDL_CACHE_MEMORY,
            'connection_timeout' => self::CONNECT_SECONDS,
            'exceptions' => true,
            'features' => SOAP_SINGLE_ELEMENT_ARRAYS,
            'stream_context' => stream_context_create([
                'http' => ['header' => "Authorization: $credential->header"],
                'ssl' => array_filter(['cafile' => $this->settings->authority]),
            ]),
            // The message of a fault is read for what PHP leaves out of it.
            'trace' => true,
        ]);
    }
}
