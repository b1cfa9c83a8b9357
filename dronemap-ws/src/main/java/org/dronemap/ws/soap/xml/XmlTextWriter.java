package org.dronemap.ws.soap.xml;

import java.util.ArrayDeque;
import java.util.Deque;
import org.jspecify.annotations.Nullable;

/** Writes indented XML text, one element on each line, for WSDL documents. Owned by who makes it. */
public final class XmlTextWriter {
    private final StringBuilder text = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private final Deque<String> open = new ArrayDeque<>();

    /** {@code attributes}: names and values in turn; one whose value is null is left out. */
    public XmlTextWriter open(String element, @Nullable String... attributes) {
        start(element, attributes).append(">\n");
        open.push(element);
        return this;
    }

    public XmlTextWriter close() {
        String element = open.pop();
        indent().append("</").append(element).append(">\n");
        return this;
    }

    public XmlTextWriter empty(String element, @Nullable String... attributes) {
        start(element, attributes).append("/>\n");
        return this;
    }

    public XmlTextWriter leaf(String element, String words) {
        XmlText.append(start(element).append('>'), words, true);
        text.append("</").append(element).append(">\n");
        return this;
    }

    private StringBuilder start(String element, @Nullable String... attributes) {
        indent().append('<').append(element);
        for (int i = 0; i < attributes.length; i += 2) {
            String value = attributes[i + 1];
            if (value != null) {
                text.append(' ').append(attributes[i]).append("=\"");
                XmlText.append(text, value, true);
                text.append('"');
            }
        }
        return text;
    }

    private StringBuilder indent() {
        return text.append("  ".repeat(open.size()));
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
