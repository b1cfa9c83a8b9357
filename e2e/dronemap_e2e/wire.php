<?php
// What PHP's own SoapClient makes of the service: php wire.php ADDRESS KEY VERSION DRONE

[, $address, $key, $version, $drone] = $argv;

function client(string $address, string $key, string $version, string $service): SoapClient
{
    return new SoapClient("$address/services/$service?wsdl", [
        'soap_version' => $version === '1.2' ? SOAP_1_2 : SOAP_1_1,
        'exceptions' => true,
        'stream_context' => stream_context_create(['http' => ['header' => "Authorization: Bearer $key"]]),
    ]);
}

function call(SoapClient $client, string $operation, array $arguments = []): void
{
    try {
        $client->__soapCall($operation, [$arguments]);
    } catch (SoapFault $fault) {
        // A fault is as good a thing to keep as an answer.
    }
}

$controller = client($address, $key, $version, 'MAVLinkControllerService');
call($controller, 'getDronesList');
call($controller, 'getDrone', ['droneId' => $drone]);
call($controller, 'getDrone', ['droneId' => 'nosuchdrone']);
call($controller, 'takePicture', ['droneId' => $drone]);
if ($version === '1.1') {
    call($controller, 'arm', ['droneId' => $drone]);
    call($controller, 'takeoff', ['droneId' => $drone, 'altitude' => 8]);
    call($controller, 'goto', [
        'droneId' => $drone, 'latitude' => 47.3979, 'longitude' => 8.5456, 'altitude' => 10,
    ]);
    call($controller, 'goto', ['droneId' => $drone, 'latitude' => 95, 'longitude' => 8, 'altitude' => 10]);
    call($controller, 'takeoff', ['droneId' => $drone, 'altitude' => NAN]);
    call($controller, 'uploadMission', ['droneId' => $drone, 'items' => ['item' => [
        ['waypoint' => ['latitude' => 47.3979, 'longitude' => 8.5456, 'altitude' => 10]],
        ['waypoint' => ['latitude' => 47.3983, 'longitude' => 8.5462, 'altitude' => 10, 'holdSeconds' => 1]],
    ]]]);
    call($controller, 'getControl', ['droneId' => $drone]);
    call(client($address, $key, $version, 'VirtualDroneService'), 'listVirtualDrones');
    call($controller, 'land', ['droneId' => $drone]);
    call(client($address, 'wrong', $version, 'MAVLinkControllerService'), 'getDronesList');
    call(client($address, $key, $version, 'FollowerService'), 'getFollowsList');
}
