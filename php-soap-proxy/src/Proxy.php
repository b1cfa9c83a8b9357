<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy;

use Dronemap\SoapProxy\Contract\AnswerWriter;
use Dronemap\SoapProxy\Contract\ArgumentReader;
use Dronemap\SoapProxy\Contract\Contract;
use Dronemap\SoapProxy\Http\Request;
use Dronemap\SoapProxy\Http\Response;
use Dronemap\SoapProxy\Session\Sessions;
use Dronemap\SoapProxy\Soap\Credential;
use Dronemap\SoapProxy\Soap\SoapServer;

/** Carries one call of a page to SOAP, and the answer back as JSON. */
final readonly class Proxy
{
    public function __construct(private Contract $contract, private Sessions $sessions, private SoapServer $server)
    {
    }

    public function answer(Request $request): Response
    {
        $session = $this->sessions->held($request);
        if (!in_array($request->method, ['GET', 'POST'], true)) {
            $detail = 'Operations are called by GET or POST.';
            throw Problem::own(405, 'method', 'method-not-taken', 'Not that method', $detail);
        }
        $name = $request->query['operation'] ?? '';
        $operation = $this->contract->operation(is_string($name) ? $name : '');
        $arguments = (new ArgumentReader($this->contract))->read($operation, $request);
        $answer = $this->server->call($operation, $arguments, Credential::key($session->key));
        return $operation->answer === null
            ? Response::nothing()
            : Response::json((new AnswerWriter($this->contract))->write($operation->answer, $answer));
    }
}
