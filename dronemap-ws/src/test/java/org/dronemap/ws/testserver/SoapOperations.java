package org.dronemap.ws.testserver;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import javax.xml.XMLConstants;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;
import tools.jackson.databind.JsonNode;

/** The operations of SOAP: as the WSDLs of a running house describe them, and which of REST each is, by REST's description. */
public final class SoapOperations {
    private static final String WSDL = "http://schemas.xmlsoap.org/wsdl/";
    static final String SCHEMA = XMLConstants.W3C_XML_SCHEMA_NS_URI;
    private static final Pattern SERVICE = Pattern.compile("/services/\\w+(?=\\?wsdl)");

    private final Map<String, Operation> described = new TreeMap<>();
    /** Names of operations that more than one service has. */
    private final Set<String> doubled = new TreeSet<>();

    private final Map<String, String> ofRest;
    private final Set<String> services = new TreeSet<>();

    /**
     * One operation.
     *
     * @param service the address of its service
     * @param members the elements of a call, in the order of the schema: first those that stand in REST's address
     * @param declaration the element of a call, in its schema
     */
    public record Operation(String name, String service, List<OrganisationMember> members, Element declaration) {
        /** The members of an object as the elements of a call. */
        public String written(JsonNode object) {
            return new SoapElements(declaration.getOwnerDocument().getDocumentElement()).members(declaration, object);
        }
    }

    /** {@code type}: the local name of its type, such as {@code string}; empty where the type has no name. */
    public record OrganisationMember(String name, String type, boolean required) {}

    public SoapOperations(TestServer house) {
        TestHttpClient http = new TestHttpClient(house, "");
        Matcher found = SERVICE.matcher(http.get("/services").raw().body());
        while (found.find()) {
            services.add(found.group());
        }
        for (String service : services) {
            read(service, parse(http.get(service + "?wsdl").raw().body()));
        }
        ofRest = named(http.get("/api/openapi.json").json());
    }

    private void read(String service, Document wsdl) {
        Map<String, Element> declared = new LinkedHashMap<>();
        for (Element schema : within(wsdl.getDocumentElement(), SCHEMA, "schema")) {
            for (Element element : children(schema)) {
                if (element.getLocalName().equals("element")) {
                    declared.put(element.getAttribute("name"), element);
                }
            }
        }
        Element portType = within(wsdl.getDocumentElement(), WSDL, "portType").get(0);
        for (Element operation : within(portType, WSDL, "operation")) {
            String name = operation.getAttribute("name");
            Element element = Optional.ofNullable(declared.get(name)).orElseThrow();
            if (described.put(name, new Operation(name, service, members(element), element)) != null) {
                doubled.add(name);
            }
        }
    }

    private static List<OrganisationMember> members(Element wrapper) {
        List<OrganisationMember> all = new ArrayList<>();
        for (Element type : children(wrapper)) {
            for (Element sequence : children(type)) {
                for (Element member : children(sequence)) {
                    all.add(new OrganisationMember(
                            member.getAttribute("name"),
                            member.getAttribute("type").replaceFirst(".*:", ""),
                            !member.getAttribute("minOccurs").equals("0")));
                }
            }
        }
        return List.copyOf(all);
    }

    /** Which operation of REST each name stands for; those that say that SOAP does not have them are left out. */
    private static Map<String, String> named(JsonNode openApi) {
        Map<String, String> names = new TreeMap<>();
        openApi.path("paths")
                .properties()
                .forEach(path -> path.getValue().properties().forEach(method -> {
                    JsonNode operation = method.getValue();
                    String rest = method.getKey().toUpperCase(Locale.ROOT) + " " + path.getKey();
                    if (!path.getKey().startsWith("/api/v1") || operation.has("x-without-soap")) {
                        return;
                    }
                    JsonNode kinds = kinds(openApi, operation);
                    kinds.propertyNames()
                            .forEach(kind -> names.put(
                                    operation.path("x-soap-names").path(kind).asString(kind), rest));
                    if (kinds.isEmpty()) {
                        names.put(
                                operation
                                        .path("x-soap-name")
                                        .asString(operation.path("operationId").asString()),
                                rest);
                    }
                }));
        return names;
    }

    /** The alternatives that the body of an operation may be. */
    private static JsonNode kinds(JsonNode openApi, JsonNode operation) {
        JsonNode body = operation
                .path("requestBody")
                .path("content")
                .path("application/json")
                .path("schema");
        String name = body.path("$ref").asString("").replaceFirst(".*/", "");
        return openApi.path("components")
                .path("schemas")
                .path(name)
                .path("discriminator")
                .path("mapping");
    }

    /** All names, over all services. */
    public Set<String> names() {
        return described.keySet();
    }

    /** The addresses of all services. */
    public Set<String> services() {
        return services;
    }

    /** Names that clients could take for another service's. */
    public Set<String> doubled() {
        return doubled;
    }

    /** The names that there should be, by REST's description. */
    public Set<String> namesByRest() {
        return ofRest.keySet();
    }

    public Operation get(String name) {
        return Optional.ofNullable(described.get(name))
                .orElseThrow(() -> new IllegalArgumentException("SOAP has no operation " + name));
    }

    /** Such as {@code POST /api/v1/drones/{id}/commands}. */
    public String restOf(String name) {
        return Optional.ofNullable(ofRest.get(name))
                .orElseThrow(() -> new IllegalArgumentException("REST has no operation " + name));
    }

    /** Those that are this one of REST: more than one where its body has alternatives. */
    public Set<String> of(String rest) {
        return ofRest.entrySet().stream()
                .filter(one -> one.getValue().equals(rest))
                .map(Map.Entry::getKey)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    static Document parse(String xml) {
        try {
            DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
            factory.setNamespaceAware(true);
            return factory.newDocumentBuilder().parse(new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)));
        } catch (ParserConfigurationException | IOException e) {
            throw new IllegalStateException(e);
        } catch (SAXException notXml) {
            throw new IllegalStateException(xml, notXml);
        }
    }

    static List<Element> within(Element element, String namespace, String name) {
        List<Element> all = new ArrayList<>();
        var found = element.getElementsByTagNameNS(namespace, name);
        for (int i = 0; i < found.getLength(); i++) {
            all.add((Element) found.item(i));
        }
        return all;
    }

    static List<Element> children(Element element) {
        List<Element> all = new ArrayList<>();
        for (Node node = element.getFirstChild(); node != null; node = node.getNextSibling()) {
            if (node instanceof Element child) {
                all.add(child);
            }
        }
        return all;
    }
}
