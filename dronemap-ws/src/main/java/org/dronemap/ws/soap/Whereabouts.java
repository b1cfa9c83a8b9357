package org.dronemap.ws.soap;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.util.StreamReaderDelegate;

/** A reader of SOAP messages that knows which element it is in, as a caller would name it: {@code waypoint[1].latitude}. */
final class Whereabouts extends StreamReaderDelegate {
    /** Envelope, body and operation are around every value. */
    private static final int OUTER = 3;
    /** The parser counts them by its settings of before any message, which cannot be changed from here. */
    private static final int MOST_ATTRIBUTES = 50;
    /** What may stand more than once is numbered from the first on. */
    private static final Set<String> REPEATED = Set.of("waypoint", "visit");

    private final Deque<Element> open = new ArrayDeque<>();
    private final Map<String, Value> seen = new LinkedHashMap<>();
    private boolean leaving;
    private boolean inBody;

    /** {@code path} is as a caller would name it, {@code kind} the same without the numbers. */
    private record Element(String path, String kind, Map<String, Integer> children, StringBuilder text) {
        Element(String path, String kind) {
            this(path, kind, new HashMap<>(), new StringBuilder());
        }
    }

    /** Where something stood, its text, and its namespace, empty for none. */
    record Value(String path, CharSequence text, String namespace) {}

    /** The reader stands at the start of the outermost element. */
    Whereabouts(XMLStreamReader reader) {
        super(reader);
        enter();
    }

    /** The value that is read, or was just read to its end; empty outside of all values. */
    String path() {
        Element element = open.peek();
        return element == null ? "" : element.path();
    }

    /** The last of each kind of value, such as {@code waypoint.latitude}. */
    Map<String, Value> seen() {
        return Collections.unmodifiableMap(seen);
    }

    @Override
    public int next() throws XMLStreamException {
        if (leaving) {
            open.pop();
        }
        int event = super.next();
        if (event == XMLStreamConstants.START_ELEMENT) {
            enter();
        } else if (event == XMLStreamConstants.CHARACTERS || event == XMLStreamConstants.CDATA) {
            keep(getText());
        }
        leaving = event == XMLStreamConstants.END_ELEMENT;
        return event;
    }

    @Override
    public int nextTag() throws XMLStreamException {
        int event = next();
        while (event != XMLStreamConstants.START_ELEMENT && event != XMLStreamConstants.END_ELEMENT) {
            if (event == XMLStreamConstants.CHARACTERS && !isWhiteSpace()) {
                throw new XMLStreamException("text where an element was expected", getLocation());
            }
            event = next();
        }
        return event;
    }

    @Override
    public String getElementText() throws XMLStreamException {
        String text = super.getElementText();
        keep(text);
        leaving = true;
        return text;
    }

    private void keep(String text) {
        Element element = open.peek();
        if (element != null) {
            element.text().append(text);
        }
    }

    private String namespace() {
        String uri = getNamespaceURI();
        return uri == null ? "" : uri;
    }

    /** One of a foreign namespace is not made good by another one. */
    private static Value laterOrForeign(Value before, Value later) {
        return before.namespace().isEmpty() ? later : before;
    }

    private void enter() {
        if (getAttributeCount() > MOST_ATTRIBUTES) {
            throw FaultWords.unreadable("An element may have at most " + MOST_ATTRIBUTES + " attributes.");
        }
        Element parent = open.peek();
        String name = getLocalName();
        if (parent == null || open.size() < OUTER) {
            inBody = open.size() == 1 ? name.equals("Body") : inBody;
            open.push(new Element("", ""));
            return;
        }
        int index = parent.children().merge(name, 1, Integer::sum) - 1;
        String before = parent.path().isEmpty() ? "" : parent.path() + ".";
        String kind = (parent.kind().isEmpty() ? "" : parent.kind() + ".") + name;
        String numbered = index == 0 && !REPEATED.contains(kind) ? name : name + "[" + index + "]";
        Element element = new Element(before + numbered, kind);
        open.push(element);
        if (inBody) {
            seen.merge(kind, new Value(element.path(), element.text(), namespace()), Whereabouts::laterOrForeign);
        }
    }
}
