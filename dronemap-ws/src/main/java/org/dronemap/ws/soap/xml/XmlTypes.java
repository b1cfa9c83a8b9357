package org.dronemap.ws.soap.xml;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/** All named XML types that SOAP operations take and return. Immutable. */
public record XmlTypes(Map<String, Complex> named) {

    /** Something with elements of its own. */
    public sealed interface Complex {
        String words();
    }

    public record Structure(List<XmlMember> members, String words) implements Complex {
        @Nullable
        public XmlMember member(String name) {
            return members.stream()
                    .filter(one -> one.name().equals(name))
                    .findFirst()
                    .orElse(null);
        }
    }

    /**
     * Exactly one of several, each an element called as the alternative.
     *
     * @param discriminator the member of JSON that says which it is
     * @param kinds the named type of each alternative
     */
    public record Alternatives(String discriminator, Map<String, String> kinds, String words) implements Complex {}

    public Complex get(String name) {
        Complex found = named.get(name);
        if (found == null) {
            throw new IllegalStateException("the description has no type " + name);
        }
        return found;
    }

    public Structure structure(String name) {
        if (get(name) instanceof Structure structure) {
            return structure;
        }
        throw new IllegalStateException(name + " has no members of its own");
    }
}
