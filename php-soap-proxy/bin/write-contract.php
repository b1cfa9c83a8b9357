<?php

// php bin/write-contract.php [FOLDER-WITH-WSDLS]: writes src/Contract/contract.php.

declare(strict_types=1);

require __DIR__ . '/../src/autoload.php';

$folder = $argv[1] ?? __DIR__ . '/../../dronemap-ws/src/test/resources/wire/wsdl';
file_put_contents(
    __DIR__ . '/../src/Contract/contract.php',
    (new Dronemap\SoapProxy\Contract\ContractWriter())->write($folder),
);
