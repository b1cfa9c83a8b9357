<?php
// Each service as PHP's own SoapClient has it: php every_service.php ADDRESS KEY VERSION SERVICE=OPERATION…
// One line of JSON for each call: the answer, or the fault.

[, $address, $key, $version] = $argv;

function told(string $service, string $operation, array $arguments = []): void
{
    global $address, $key, $version;
    $client = new SoapClient("$address/services/$service?wsdl", [
        'soap_version' => $version === '1.2' ? SOAP_1_2 : SOAP_1_1,
        'cache_wsdl' => WSDL_CACHE_NONE,
        'stream_context' => stream_context_create(['http' => ['header' => "Authorization: Bearer $key"]]),
    ]);
    try {
        $told = ['answer' => $client->__soapCall($operation, [$arguments])];
    } catch (SoapFault $fault) {
        $told = ['fault' => $fault->getMessage()];
    }
    echo json_encode(['service' => $service, 'operation' => $operation] + $told), "\n";
}

foreach (array_slice($argv, 4) as $pair) {
    [$service, $operation] = explode('=', $pair);
    told($service, $operation);
}
told('AccountService', 'makeAccessKey', ['label' => 'of all drones']);
told('AccountService', 'makeAccessKey', ['label' => 'of no drone', 'drones' => ['item' => []]]);
told('MAVLinkControllerService', 'getDrone', ['droneId' => 'nosuchdrone']);
