package org.dronemap.ws.testserver;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.w3c.dom.Element;

/** A SOAP client that knows only the WSDLs: it calls operations by their names, with elements by theirs. */
public final class SoapClient {
    /** The value of an element that is there and has none. */
    public static final Object NIL = new Object();

    private static final String NAMESPACE = "http://cloud.dronemap.org/wsdl";

    private final SoapOperations operations;
    private final TestHttpClient http;
    private final String authorization;

    private SoapClient(TestServer house, String authorization) {
        this.operations = new SoapOperations(house);
        this.http = new TestHttpClient(house, "");
        this.authorization = authorization;
    }

    public static SoapClient withKey(TestServer house, String key) {
        return withHeader(house, "Bearer " + key);
    }

    public static SoapClient withHeader(TestServer house, String authorization) {
        return new SoapClient(house, authorization);
    }

    /**
     * Calls an operation with elements, by names and values in turn: a list becomes an element with items, a map one with
     * elements; what is null is left out.
     *
     * @throws Refused when it is answered with a fault
     */
    public Answer call(String operation, @Nullable Object... namesAndValues) {
        StringBuilder elements = new StringBuilder();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            elements.append(element(String.valueOf(namesAndValues[i]), namesAndValues[i + 1]));
        }
        String service = operations.get(operation).service();
        TestHttpClient.Answer answer = http.send(
                service,
                request -> request.header("Content-Type", "text/xml")
                        .header("Authorization", authorization)
                        .POST(HttpRequest.BodyPublishers.ofString(envelope("", call(operation, elements)))));
        return read(answer.raw().body());
    }

    /** A message of SOAP 1.1. */
    public static String envelope(String header, String body) {
        return "<s:Envelope xmlns:s=\"http://schemas.xmlsoap.org/soap/envelope/\""
                + " xmlns:w=\"" + NAMESPACE + "\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">"
                + (header.isEmpty() ? "" : "<s:Header>" + header + "</s:Header>") + "<s:Body>" + body
                + "</s:Body></s:Envelope>";
    }

    /** What stands in the body of a message of {@link #envelope}. */
    static String call(String operation, CharSequence elements) {
        return "<w:" + operation + ">" + elements + "</w:" + operation + ">";
    }

    /** One element of a call, as {@link #call(String, Object...)} writes it. */
    static String element(String name, @Nullable Object value) {
        if (value == null) {
            return "";
        }
        return value == NIL
                ? "<" + name + " xsi:nil=\"true\"/>"
                : "<" + name + ">" + content(value) + "</" + name + ">";
    }

    static String content(Object value) {
        if (value instanceof Map<?, ?> members) {
            return members.entrySet().stream()
                    .map(member -> element(String.valueOf(member.getKey()), member.getValue()))
                    .collect(Collectors.joining());
        }
        if (value instanceof List<?> items) {
            return items.stream().map(item -> element("item", item)).collect(Collectors.joining());
        }
        return value.toString().replace("&", "&amp;").replace("<", "&lt;");
    }

    private static Answer read(String envelope) {
        Element root = SoapOperations.parse(envelope).getDocumentElement();
        for (Element fault : SoapOperations.within(root, root.getNamespaceURI(), "Fault")) {
            throw new Refused(fault);
        }
        Element body =
                SoapOperations.within(root, root.getNamespaceURI(), "Body").get(0);
        return new Answer(SoapOperations.children(body).get(0));
    }

    /** The element that answers a call. */
    public static final class Answer {
        private final Element response;

        private Answer(Element response) {
            this.response = response;
        }

        /** The texts of all elements that are there, such as {@code drones.item.id}. */
        public List<String> texts(String path) {
            List<Element> found = List.of(response);
            for (String name : ("return." + path).split("\\.", -1)) {
                List<Element> next = new ArrayList<>();
                found.forEach(one -> SoapOperations.children(one).stream()
                        .filter(child -> child.getLocalName().equals(name))
                        .forEach(next::add));
                found = next;
            }
            return found.stream().map(Element::getTextContent).toList();
        }

        /** The text of the one element that is there; empty when there is none. */
        public String text(String path) {
            List<String> all = texts(path);
            if (all.size() > 1) {
                throw new IllegalStateException(path + " is there " + all.size() + " times: " + all);
            }
            return all.isEmpty() ? "" : all.get(0);
        }
    }

    /** A fault: its message is the sentence of the fault. */
    public static final class Refused extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient Element fault;

        private Refused(Element fault) {
            super(SoapOperations.children(fault).stream()
                    .filter(child -> child.getLocalName().equals("faultstring"))
                    .map(Element::getTextContent)
                    .findFirst()
                    .orElse(""));
            this.fault = fault;
        }

        /** A member of the problem in the fault, such as {@code code}; empty when it has none. */
        public String member(String name) {
            return SoapOperations.within(fault, NAMESPACE, "DronemapFault").stream()
                    .flatMap(detail -> SoapOperations.children(detail).stream())
                    .filter(child -> child.getLocalName().equals(name))
                    .map(Element::getTextContent)
                    .findFirst()
                    .orElse("");
        }
    }
}
