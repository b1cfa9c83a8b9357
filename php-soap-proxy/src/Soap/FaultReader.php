<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Soap;

use DOMDocument;
use DOMElement;
use Dronemap\SoapProxy\Problem;
use SoapFault;

/** Makes a problem of a fault: the server's own with each of its members, or what became of the call on the way. */
final readonly class FaultReader
{
    private const ENCODING = 'SOAP-ERROR: Encoding';
    private const NUMBERS = ['status', 'retryAfterSeconds'];

    /** @param bool $described whether the WSDL had been read, so that the call may have gone out */
    public static function problem(SoapFault $fault, ?string $message, bool $described, string $server): Problem
    {
        $told = $message === null ? null : self::fromMessage($message);
        if ($told !== null) {
            return new Problem($told);
        }
        $reason = $fault->getMessage();
        // In these cases nothing of the call has left this machine.
        if (!$described || $reason === 'Could not connect to host' || str_starts_with($reason, self::ENCODING)) {
            return self::unsent($reason, $server);
        }
        return Problem::own(
            504,
            'no-answer',
            'proxy-server-timeout',
            'No answer',
            "The Dronemap server took the request and did not answer it ($reason): whether it was carried out is not"
                . ' known. Look at the drone before you ask again.',
        );
    }

    private static function unsent(string $reason, string $server): Problem
    {
        if (str_starts_with($reason, self::ENCODING)) {
            return Problem::own(422, 'invalid-value', 'value-malformed', 'A value is missing or out of range', $reason);
        }
        return Problem::own(
            502,
            'no-answer',
            'proxy-server-unreachable',
            'No server',
            "The Dronemap server at $server cannot be reached; nothing was sent to it.",
        );
    }

    /** @return ?array<string, mixed> the members of the problem in a message; null where it has none */
    private static function fromMessage(string $message): ?array
    {
        if (str_starts_with(ltrim($message), '{')) {
            $json = json_decode($message, true);
            return is_array($json) && isset($json['detail'], $json['status'], $json['code']) ? $json : null;
        }
        $document = new DOMDocument();
        if ($message === '' || !$document->loadXML($message, LIBXML_NOERROR | LIBXML_NOWARNING | LIBXML_NONET)) {
            return null;
        }
        $problem = $document->getElementsByTagNameNS('*', 'DronemapFault')->item(0);
        if ($problem === null) {
            return null;
        }
        $members = [];
        foreach (self::children($problem) as $child) {
            $members[$child->localName] = match (true) {
                $child->localName === 'parameters' => (object) self::entries($child),
                in_array($child->localName, self::NUMBERS, true) => (int) $child->textContent,
                default => $child->textContent,
            };
        }
        return $members;
    }

    /** @return array<string, string|int|float|bool> */
    private static function entries(DOMElement $map): array
    {
        $entries = [];
        foreach (self::children($map) as $entry) {
            $entries[$entry->getAttribute('key')] = MapValue::of($entry->textContent, $entry->getAttribute('type'));
        }
        return $entries;
    }

    /** @return list<DOMElement> */
    private static function children(DOMElement $element): array
    {
        return array_values(array_filter(
            iterator_to_array($element->childNodes),
            static fn ($child): bool => $child instanceof DOMElement,
        ));
    }
}
