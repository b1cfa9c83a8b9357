"""What a WSDL says: operations with the members of what goes in and comes out."""

from dataclasses import dataclass
from xml.etree import ElementTree

WSDL = "{http://schemas.xmlsoap.org/wsdl/}"
XSD = "{http://www.w3.org/2001/XMLSchema}"


@dataclass(frozen=True)
class Member:
    name: str
    type: str
    optional: bool
    about: str


@dataclass(frozen=True)
class SoapOperation:
    name: str
    about: str
    takes: tuple[Member, ...]
    answers: tuple[Member, ...]


@dataclass(frozen=True)
class Service:
    name: str
    namespace: str
    path: str
    operations: dict[str, SoapOperation]

    @classmethod
    def of(cls, root: ElementTree.Element) -> "Service":
        elements = {
            element.get("name", ""): tuple(_members(element))
            for schema in root.iter(f"{XSD}schema")
            for element in schema.findall(f"{XSD}element")
        }
        name = root.get("name", "")
        operations = {
            operation.get("name", ""): SoapOperation(
                operation.get("name", ""),
                operation.findtext(f"{WSDL}documentation", "").strip(),
                elements.get(operation.get("name", ""), ()),
                elements.get(f"{operation.get('name')}Response", ()),
            )
            for port in root.findall(f"{WSDL}portType")
            for operation in port.findall(f"{WSDL}operation")
        }
        return cls(name, root.get("targetNamespace", ""), f"/services/{name}", dict(sorted(operations.items())))


def _members(element: ElementTree.Element) -> list[Member]:
    inner = element.findall(f"{XSD}complexType/{XSD}sequence/{XSD}element")
    return [
        Member(
            member.get("name", ""),
            member.get("type", "").partition(":")[2] or _values(member),
            member.get("minOccurs") == "0" or member.get("nillable") == "true",
            member.findtext(f"{XSD}annotation/{XSD}documentation", "").strip(),
        )
        for member in inner
    ]


def _values(member: ElementTree.Element) -> str:
    values = [value.get("value", "") for value in member.iter(f"{XSD}enumeration")]
    return ", ".join(f"`{value}`" for value in values) or "string"
