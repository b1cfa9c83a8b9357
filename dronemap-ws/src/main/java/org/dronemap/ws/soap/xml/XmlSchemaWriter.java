package org.dronemap.ws.soap.xml;

import java.util.Collection;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** Writes the types of SOAP as XML Schema into a WSDL. */
public final class XmlSchemaWriter {
    public static final String PREFIX = "t";

    private final XmlTypes types;
    private final XmlTextWriter out;
    private final Map<String, XmlTypes.Complex> named = new TreeMap<>();
    private final Map<String, XmlType> several = new TreeMap<>();

    public XmlSchemaWriter(XmlTypes types, XmlTextWriter out) {
        this.types = types;
        this.out = out;
    }

    /** The types of {@code members} and all that those are made of. */
    public void write(Collection<XmlMember> members) {
        members.forEach(member -> reach(member.type()));
        out.open(
                "xs:schema",
                "xmlns:" + PREFIX,
                SoapNamespaces.TYPES,
                "targetNamespace",
                SoapNamespaces.TYPES,
                "version",
                "2");
        named.forEach(this::complex);
        several.forEach(this::several);
        out.close();
    }

    private void reach(XmlType type) {
        if (type instanceof XmlType.Listed listed) {
            several.put(name(listed), type);
            reach(listed.item());
        } else if (type instanceof XmlType.Mapped mapped) {
            several.put(name(mapped), type);
            reach(mapped.value());
        } else if (type instanceof XmlType.Named one) {
            reach(one.name());
        }
    }

    private void reach(String name) {
        XmlTypes.Complex type = types.get(name);
        if (named.put(name, type) != null) {
            return;
        }
        if (type instanceof XmlTypes.Structure structure) {
            structure.members().forEach(member -> reach(member.type()));
        } else if (type instanceof XmlTypes.Alternatives alternatives) {
            alternatives.kinds().values().forEach(this::reach);
        }
    }

    /** Lists have types with names: programs make classes of them, and one within another must not be called as that is. */
    private static String name(XmlType type) {
        if (type instanceof XmlType.Listed listed) {
            return "ListOf" + name(listed.item());
        }
        if (type instanceof XmlType.Mapped mapped) {
            return "MapOf" + name(mapped.value());
        }
        if (type instanceof XmlType.Named one) {
            return one.name();
        }
        if (type instanceof XmlType.Plain) {
            return "Plain";
        }
        String xsd = type instanceof XmlType.Text text ? text.xsd() : "string";
        return xsd.substring(0, 1).toUpperCase(Locale.ROOT) + xsd.substring(1);
    }

    private void several(String name, XmlType type) {
        out.open("xs:complexType", "name", name).open("xs:sequence");
        if (type instanceof XmlType.Listed listed) {
            element(XmlToJson.ITEM, listed.item(), new Occurs("0", "unbounded", null), "");
        } else if (type instanceof XmlType.Mapped mapped) {
            entries(mapped);
        }
        out.close().close();
    }

    private void complex(String name, XmlTypes.Complex type) {
        out.open("xs:complexType", "name", name);
        words(type.words());
        if (type instanceof XmlTypes.Structure structure) {
            sequence(structure.members());
        } else if (type instanceof XmlTypes.Alternatives alternatives) {
            out.open("xs:choice");
            alternatives
                    .kinds()
                    .forEach((kind, of) -> out.empty("xs:element", "name", kind, "type", PREFIX + ":" + of));
            out.close();
        }
        out.close();
    }

    /** Absent and without a value are alike in an answer; in a call some members know both. */
    public void sequence(List<XmlMember> members) {
        if (members.isEmpty()) {
            out.empty("xs:sequence");
            return;
        }
        out.open("xs:sequence");
        for (XmlMember member : members) {
            boolean always = member.required() && !member.nullable();
            Occurs occurs = new Occurs(always ? null : "0", null, member.nullable() ? "true" : null);
            element(member.name(), member.type(), occurs, member.words());
        }
        out.close();
    }

    /** As attributes have it; null: as XML Schema has it where nothing is said. */
    private record Occurs(
            @Nullable String least,
            @Nullable String most,
            @Nullable String nillable) {}

    private void element(String name, XmlType type, Occurs occurs, String words) {
        if (type instanceof XmlType.Text text && !text.values().isEmpty()) {
            out.open(
                    "xs:element",
                    "name",
                    name,
                    "minOccurs",
                    occurs.least(),
                    "maxOccurs",
                    occurs.most(),
                    "nillable",
                    occurs.nillable());
            words(words);
            values(text);
            out.close();
            return;
        }
        String of = PREFIX + ":" + name(type);
        if (type instanceof XmlType.Text text) {
            of = "xs:" + text.xsd();
        }
        described(
                words,
                "name",
                name,
                "type",
                of,
                "minOccurs",
                occurs.least(),
                "maxOccurs",
                occurs.most(),
                "nillable",
                occurs.nillable());
    }

    private void described(String words, @Nullable String... attributes) {
        if (words.isEmpty()) {
            out.empty("xs:element", attributes);
        } else {
            out.open("xs:element", attributes);
            words(words);
            out.close();
        }
    }

    private void words(String words) {
        if (!words.isEmpty()) {
            out.open("xs:annotation").leaf("xs:documentation", words).close();
        }
    }

    private void values(XmlType.Text text) {
        out.open("xs:simpleType").open("xs:restriction", "base", "xs:" + text.xsd());
        text.values().forEach(value -> out.empty("xs:enumeration", "value", value));
        out.close().close();
    }

    private void entries(XmlType.Mapped mapped) {
        out.open("xs:element", "name", XmlToJson.ENTRY, "minOccurs", "0", "maxOccurs", "unbounded");
        out.open("xs:complexType");
        boolean plain = mapped.value() instanceof XmlType.Plain;
        boolean simple = plain || mapped.value() instanceof XmlType.Text;
        String base = PREFIX + ":" + name(mapped.value());
        if (simple) {
            base = mapped.value() instanceof XmlType.Text text ? "xs:" + text.xsd() : "xs:string";
        }
        out.open(simple ? "xs:simpleContent" : "xs:complexContent").open("xs:extension", "base", base);
        out.empty("xs:attribute", "name", XmlToJson.KEY, "type", "xs:string", "use", "required");
        if (plain) {
            out.empty("xs:attribute", "name", XmlToJson.TYPE, "type", "xs:string", "use", "required");
        }
        out.close().close();
        out.close().close();
    }
}
