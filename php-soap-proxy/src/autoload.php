<?php

declare(strict_types=1);

// Classes by PSR-4; composer's own autoloader does the same where somebody uses composer.
spl_autoload_register(static function (string $class): void {
    $prefix = 'Dronemap\\SoapProxy\\';
    if (str_starts_with($class, $prefix)) {
        require __DIR__ . '/' . str_replace('\\', '/', substr($class, strlen($prefix))) . '.php';
    }
});
