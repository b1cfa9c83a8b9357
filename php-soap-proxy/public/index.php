<?php

declare(strict_types=1);

// The page itself, with the headers that a file alone would not have.
header_remove('X-Powered-By');
header("Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:;"
    . " connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
header('X-Content-Type-Options: nosniff');
header('Referrer-Policy: no-referrer');
header('Cache-Control: no-cache');
header('Content-Type: text/html; charset=utf-8');
readfile(__DIR__ . '/../page.html');
