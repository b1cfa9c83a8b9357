package org.dronemap.ws.soap;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** Writes types as XML Schema. */
final class TypeSchema {
    static final String PREFIX = "t";

    private final XmlTypes types;
    private final XmlText out;

    TypeSchema(XmlTypes types, XmlText out) {
        this.types = types;
        this.out = out;
    }

    /** The types of {@code members} and all that those are made of. */
    void write(Collection<XmlMember> members) {
        Map<String, XmlTypes.Complex> reached = new TreeMap<>();
        Deque<String> open = new ArrayDeque<>();
        members.forEach(member -> names(member.type()).forEach(open::add));
        while (!open.isEmpty()) {
            String name = open.remove();
            XmlTypes.Complex type = types.get(name);
            if (reached.put(name, type) == null) {
                parts(type).forEach(open::add);
            }
        }
        out.open("xs:schema", "xmlns:" + PREFIX, Namespace.TYPES, "targetNamespace", Namespace.TYPES, "version", "2");
        reached.forEach(this::complex);
        out.close();
    }

    private static Stream<String> parts(XmlTypes.Complex type) {
        if (type instanceof XmlTypes.Structure structure) {
            return structure.members().stream().flatMap(member -> names(member.type()));
        }
        return ((XmlTypes.Alternatives) type).kinds().values().stream();
    }

    private static Stream<String> names(XmlType type) {
        if (type instanceof XmlType.Listed listed) {
            return names(listed.item());
        }
        if (type instanceof XmlType.Mapped mapped) {
            return names(mapped.value());
        }
        return type instanceof XmlType.Named named ? Stream.of(named.name()) : Stream.empty();
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
    void sequence(List<XmlMember> members) {
        if (members.isEmpty()) {
            out.empty("xs:sequence");
            return;
        }
        out.open("xs:sequence");
        for (XmlMember member : members) {
            boolean always = member.required() && !member.nullable();
            element(member.name(), member.type(), always ? null : "0", null, member.nullable(), member.words());
        }
        out.close();
    }

    private void element(
            String name, XmlType type, @Nullable String least, @Nullable String most, boolean nillable, String words) {
        String nil = nillable ? "true" : null;
        if (type instanceof XmlType.Named named) {
            described(
                    words,
                    "name",
                    name,
                    "type",
                    PREFIX + ":" + named.name(),
                    "minOccurs",
                    least,
                    "maxOccurs",
                    most,
                    "nillable",
                    nil);
        } else if (type instanceof XmlType.Text text && text.values().isEmpty()) {
            described(
                    words,
                    "name",
                    name,
                    "type",
                    "xs:" + text.xsd(),
                    "minOccurs",
                    least,
                    "maxOccurs",
                    most,
                    "nillable",
                    nil);
        } else if (type instanceof XmlType.Json) {
            String json = (words + " As JSON.").strip();
            described(json, "name", name, "type", "xs:string", "minOccurs", least, "maxOccurs", most, "nillable", nil);
        } else {
            out.open("xs:element", "name", name, "minOccurs", least, "maxOccurs", most, "nillable", nil);
            words(words);
            if (type instanceof XmlType.Text text) {
                values(text);
            } else if (type instanceof XmlType.Listed listed) {
                out.open("xs:complexType").open("xs:sequence");
                element(XmlToJson.ITEM, listed.item(), "0", "unbounded", false, "");
                out.close().close();
            } else if (type instanceof XmlType.Mapped mapped) {
                entries(mapped);
            }
            out.close();
        }
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
        out.open("xs:complexType").open("xs:sequence");
        out.open("xs:element", "name", XmlToJson.ENTRY, "minOccurs", "0", "maxOccurs", "unbounded");
        out.open("xs:complexType");
        String base = mapped.value() instanceof XmlType.Named named ? PREFIX + ":" + named.name() : "xs:string";
        boolean complex = mapped.value() instanceof XmlType.Named;
        out.open(complex ? "xs:complexContent" : "xs:simpleContent").open("xs:extension", "base", base);
        out.empty("xs:attribute", "name", XmlToJson.KEY, "type", "xs:string", "use", "required");
        out.close().close();
        out.close().close();
        out.close().close();
    }
}
