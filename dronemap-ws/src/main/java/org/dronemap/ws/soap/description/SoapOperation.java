package org.dronemap.ws.soap.description;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.ws.soap.xml.XmlMember;
import org.dronemap.ws.soap.xml.XmlType;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.jspecify.annotations.Nullable;

/**
 * One operation of SOAP, and how it maps to its operation of REST.
 *
 * @param name the element that a call is; an answer is {@code nameResponse}
 * @param of its operation of REST
 * @param body what the body of the request is made from; null: it has none
 * @param answer what {@code return} is; null: the answer is empty
 */
public record SoapOperation(
        String name,
        RestAddress of,
        List<Argument> arguments,
        @Nullable Body body,
        @Nullable Answer answer,
        String words) {

    /** An operation of REST: {@code path} with its variables in braces. */
    public record RestAddress(String id, String method, String path) {}

    /** Location of a parameter in a REST request: path or query. */
    public enum Place {
        PATH,
        QUERY
    }

    /** {@code inRest}: its name there. */
    public record Argument(XmlMember member, Place place, String inRest) {}

    /** The body of a request. */
    public sealed interface Body {
        /** Members of the body are elements of the call; {@code fixed} says which alternative it is. */
        record Members(
                XmlTypes.Structure type,
                boolean required,
                @Nullable Fixed fixed) implements Body {}

        /** The body is a file, in the element {@code content}. */
        record File(String mediaType) implements Body {}
    }

    /** A member that the name of the operation stands for. */
    public record Fixed(String member, String value) {}

    /** {@code json}: else the bytes of the answer, as base64Binary. */
    public record Answer(XmlType type, boolean json, boolean nullable) {}

    public static final String CONTENT = "content";

    public Optional<Argument> argument(String element) {
        return arguments.stream()
                .filter(one -> one.member().name().equals(element))
                .findFirst();
    }

    /** All elements of a call in the order of its schema; a call may have them in any. */
    public List<XmlMember> elements() {
        List<XmlMember> all = new ArrayList<>();
        arguments.stream()
                .filter(one -> one.place() == Place.PATH)
                .map(Argument::member)
                .forEach(all::add);
        if (body instanceof Body.Members members) {
            all.addAll(members.type().members());
        } else if (body instanceof Body.File) {
            all.add(new XmlMember(CONTENT, XmlType.Text.of("base64Binary"), true, false, "The file."));
        }
        arguments.stream()
                .filter(one -> one.place() == Place.QUERY)
                .map(Argument::member)
                .forEach(all::add);
        return all;
    }
}
