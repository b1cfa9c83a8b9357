package org.dronemap.ws.soap.xml;

import java.util.ArrayList;
import java.util.List;
import javax.xml.XMLConstants;
import org.jspecify.annotations.Nullable;

/**
 * Writes values as XML elements of a SOAP message by their types, in the order in which they come. Members without a value are left out, as their
 * schema allows, and so are those that it does not have. Owned by who makes it.
 */
final class XmlElementWriter {
    private static final String NIL =
            " xmlns:xsi=\"" + XMLConstants.W3C_XML_SCHEMA_INSTANCE_NS_URI + "\" xsi:nil=\"true\"/>";

    /** Letters: one long text would have to be copied as it grows. */
    private static final int PART = 1 << 16;

    private final XmlTypes types;
    private final String tag;
    private final String root;
    private final int longest;
    private final List<String> parts = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();
    private long written;
    private Level level;
    // Of the element that was begun last.
    private String element = "";

    /** A value that has others in it; what is in one without a type is left out. */
    private static final class Level {
        private final @Nullable Level above;
        private final @Nullable XmlType type;
        private String end;
        private boolean begun;
        private XmlTypes.@Nullable Structure structure;
        private XmlTypes.@Nullable Alternatives alternatives;
        private String name = "";
        private @Nullable XmlMember member;
        private int nextMember;

        Level(@Nullable Level above, @Nullable XmlType type, String element) {
            this.above = above;
            this.type = type;
            this.end = "</" + element + ">";
        }
    }

    /**
     * {@code tag}: the name of the outermost element, and what else stands in its tag; {@code longest}: characters, after which
     * nothing more is written.
     */
    XmlElementWriter(XmlTypes types, String tag, XmlType type, int longest) {
        this.types = types;
        this.tag = tag;
        this.root = tag.split(" ", 2)[0];
        this.longest = longest;
        this.level = new Level(null, type, "");
    }

    /** There is more than was to be written. */
    boolean isTooLong() {
        return written + text.length() > longest;
    }

    /** One after the other. */
    List<String> text() {
        cut();
        return List.copyOf(parts);
    }

    private void cut() {
        written += text.length();
        parts.add(text.toString());
        text.setLength(0);
    }

    void name(String name) {
        Level at = level;
        at.name = name;
        if (at.structure != null) {
            at.member = member(at, at.structure.members());
        }
    }

    /** They come in their order: none is looked for among those before. */
    private static @Nullable XmlMember member(Level at, List<XmlMember> members) {
        for (int i = at.nextMember; i < members.size(); i++) {
            if (members.get(i).name().equals(at.name)) {
                at.nextMember = i + 1;
                return members.get(i);
            }
        }
        for (int i = 0; i < at.nextMember; i++) {
            if (members.get(i).name().equals(at.name)) {
                throw new IllegalStateException(at.name + " is described before "
                        + members.get(at.nextMember - 1).name() + ", and written after it");
            }
        }
        return null;
    }

    /** {@code kind}: string, number or boolean. */
    void value(String value, String kind) {
        if (level.alternatives != null) {
            choose(level, level.alternatives, value);
            return;
        }
        XmlType type = open();
        if (type == null) {
            return;
        }
        if (type instanceof XmlType.Plain) {
            text.append(' ').append(XmlToJson.TYPE).append("=\"").append(kind).append('"');
        }
        text.append('>');
        XmlText.append(text, value, false);
        text.append("</").append(element).append('>');
    }

    /** In XML the name of an element says which alternative it is. */
    private void choose(Level at, XmlTypes.Alternatives alternatives, String kind) {
        if (!at.name.equals(alternatives.discriminator())) {
            throw new IllegalStateException(
                    "an alternative begins with " + at.name + " instead of " + alternatives.discriminator());
        }
        begin(at);
        text.append('<').append(kind);
        at.begun = false;
        at.end = "</" + kind + ">" + at.end;
        at.structure = types.structure(alternatives.kinds().getOrDefault(kind, ""));
        at.alternatives = null;
    }

    void nil() {
        if (level.structure == null && open() != null) {
            text.append(NIL);
        }
    }

    void start() {
        XmlType type = open();
        Level inner = new Level(level, type, element);
        if (type instanceof XmlType.Named named) {
            XmlTypes.Complex complex = types.get(named.name());
            inner.structure = complex instanceof XmlTypes.Structure structure ? structure : null;
            inner.alternatives = complex instanceof XmlTypes.Alternatives several ? several : null;
        }
        level = inner;
    }

    void end() {
        Level over = level;
        if (over.above == null) {
            throw new IllegalStateException("there is nothing to end");
        }
        level = over.above;
        if (over.type == null) {
            return;
        }
        if (over.begun) {
            text.append(over.end);
        } else {
            text.append("/>").append(over.end, over.end.indexOf('>') + 1, over.end.length());
        }
    }

    private void begin(Level at) {
        if (!at.begun) {
            at.begun = true;
            text.append('>');
        }
    }

    /** Writes the beginning of the next value's tag; the value's type, null: it is left out. */
    private @Nullable XmlType open() {
        Level at = level;
        if (isTooLong()) {
            return null;
        }
        if (text.length() > PART) {
            cut();
        }
        if (at.above == null) {
            text.append('<').append(tag);
            element = root;
            return at.type;
        }
        if (at.structure != null) {
            XmlMember member = at.member;
            return member == null ? null : open(at, member.name(), member.type());
        }
        if (at.type instanceof XmlType.Listed listed) {
            return open(at, XmlToJson.ITEM, listed.item());
        }
        if (at.type instanceof XmlType.Mapped mapped) {
            XmlType type = open(at, XmlToJson.ENTRY, mapped.value());
            text.append(' ').append(XmlToJson.KEY).append("=\"");
            XmlText.append(text, at.name, true);
            text.append('"');
            return type;
        }
        return null;
    }

    private XmlType open(Level at, String name, XmlType type) {
        begin(at);
        text.append('<').append(name);
        element = name;
        return type;
    }
}
