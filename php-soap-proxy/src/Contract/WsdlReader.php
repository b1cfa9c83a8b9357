<?php

declare(strict_types=1);

namespace Dronemap\SoapProxy\Contract;

use DOMDocument;
use DOMElement;
use DOMXPath;
use UnexpectedValueException;

/** Reads the operations and types of one service from its WSDL, as the server writes it (document/literal, wrapped). */
final class WsdlReader
{
    private readonly DOMXPath $path;

    private function __construct(DOMDocument $wsdl)
    {
        $this->path = new DOMXPath($wsdl);
        $this->path->registerNamespace('w', 'http://schemas.xmlsoap.org/wsdl/');
        $this->path->registerNamespace('x', 'http://www.w3.org/2001/XMLSchema');
    }

    public static function ofFile(string $file): self
    {
        $wsdl = new DOMDocument();
        if (!$wsdl->load($file, LIBXML_NONET)) {
            throw new UnexpectedValueException("$file is not XML.");
        }
        return new self($wsdl);
    }

    /** @return list<string> */
    public function operations(): array
    {
        return array_map(
            static fn (DOMElement $operation): string => $operation->getAttribute('name'),
            $this->all('//w:portType/w:operation'),
        );
    }

    /** @return array<string, string> */
    public function parameters(string $operation): array
    {
        return $this->members("//x:schema/x:element[@name='$operation']/x:complexType/x:sequence/x:element");
    }

    public function answer(string $operation): ?string
    {
        $returns = $this->members("//x:schema/x:element[@name='{$operation}Response']//x:element[@name='return']");
        return isset($returns['return']) ? Type::bare($returns['return']) : null;
    }

    /** Members of a type by name; those of a choice may each be left out. @return array<string, string> */
    public function type(string $name): array
    {
        $type = "//x:schema/x:complexType[@name='$name']";
        $choice = array_map(
            static fn (string $member): string => "$member?",
            $this->members("$type/x:choice/x:element"),
        );
        return $choice + $this->members("$type/x:sequence/x:element");
    }

    public function hasType(string $name): bool
    {
        return $this->all("//x:schema/x:complexType[@name='$name']") !== [];
    }

    /** @return array<string, string> */
    private function members(string $elements): array
    {
        $members = [];
        foreach ($this->all($elements) as $element) {
            $mark = match (true) {
                $element->getAttribute('nillable') === 'true' => '|null',
                $element->getAttribute('minOccurs') === '0' => '?',
                default => '',
            };
            $members[$element->getAttribute('name')] = $this->typeOf($element) . $mark;
        }
        return $members;
    }

    private function typeOf(DOMElement $element): string
    {
        $type = $element->getAttribute('type');
        if ($type === '') {
            // A type without a name is a text of which only some values are allowed.
            $bases = $this->all('x:simpleType/x:restriction', $element);
            $type = $bases === [] ? '' : $bases[0]->getAttribute('base');
        }
        $name = substr($type, (int) strpos($type, ':') + 1);
        return match (true) {
            $name === '' => throw new UnexpectedValueException('No type: ' . $element->getAttribute('name')),
            str_starts_with($name, 'ListOf') => 'list of ' . $this->typeOf($this->within($name, 'item')),
            $name === 'MapOfPlain' => 'map of plain',
            str_starts_with($name, 'MapOf') => 'map of ' . substr($name, 5),
            default => $name,
        };
    }

    private function within(string $type, string $member): DOMElement
    {
        return $this->all("//x:schema/x:complexType[@name='$type']//x:element[@name='$member']")[0]
            ?? throw new UnexpectedValueException("$type has no $member.");
    }

    /** @return list<DOMElement> */
    private function all(string $path, ?DOMElement $from = null): array
    {
        $found = $this->path->query($path, $from);
        return $found === false ? [] : array_values(array_filter(
            iterator_to_array($found),
            static fn ($node): bool => $node instanceof DOMElement,
        ));
    }
}
