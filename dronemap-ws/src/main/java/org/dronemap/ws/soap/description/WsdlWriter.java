package org.dronemap.ws.soap.description;

import java.util.ArrayList;
import java.util.List;
import javax.lang.model.SourceVersion;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.dronemap.ws.soap.xml.XmlMember;
import org.dronemap.ws.soap.xml.XmlSchemaWriter;
import org.dronemap.ws.soap.xml.XmlTextWriter;
import org.dronemap.ws.soap.xml.XmlType;
import org.dronemap.ws.soap.xml.XmlTypes;

/** Writes the WSDL 1.1 of a SOAP service: document/literal, SOAP 1.1 and 1.2 at the same address. */
public final class WsdlWriter {
    /** Of the namespace of operations, where one is written. */
    public static final String PREFIX = "ns1";

    public static final String RETURN = "return";
    public static final String FAULT = "DronemapFault";
    /** What faults carry; REST's problems. */
    public static final String PROBLEM = "Problem";

    /** Namespaces of what makes clients in Java: now, and before it was given to another foundation. */
    private static final List<String> JAVA_TOOLS =
            List.of("https://jakarta.ee/xml/ns/jaxws", "http://java.sun.com/xml/ns/jaxws");

    private static final String SOAP_11 = "soap";
    private static final String SOAP_12 = "soap12";

    private final XmlTextWriter out = new XmlTextWriter();
    private final SoapService service;
    private final XmlTypes types;

    private WsdlWriter(SoapService service, XmlTypes types) {
        this.service = service;
        this.types = types;
    }

    /** {@code address}: where the service is, as its caller reached it. */
    public static String write(SoapService service, XmlTypes types, String address) {
        return new WsdlWriter(service, types).write(address);
    }

    private String write(String address) {
        out.open(
                "wsdl:definitions",
                "xmlns:wsdl",
                "http://schemas.xmlsoap.org/wsdl/",
                "xmlns:soap",
                "http://schemas.xmlsoap.org/wsdl/soap/",
                "xmlns:soap12",
                "http://schemas.xmlsoap.org/wsdl/soap12/",
                "xmlns:xs",
                "http://www.w3.org/2001/XMLSchema",
                "xmlns:tns",
                SoapNamespaces.URI,
                "name",
                service.name(),
                "targetNamespace",
                SoapNamespaces.URI);
        types();
        service.operations().forEach(operation -> {
            message(operation.name(), operation.name());
            message(operation.name() + "Response", operation.name() + "Response");
        });
        message(FAULT, FAULT);
        portType();
        binding(SOAP_11);
        binding(SOAP_12);
        out.open("wsdl:service", "name", service.name());
        port(SOAP_11, address);
        port(SOAP_12, address);
        return out.close().close().toString();
    }

    private void types() {
        out.open("wsdl:types");
        List<XmlMember> all = new ArrayList<>();
        all.add(fault());
        for (SoapOperation operation : service.operations()) {
            all.addAll(operation.elements());
            all.addAll(answer(operation));
        }
        XmlSchemaWriter schema = new XmlSchemaWriter(types, out);
        schema.write(all);
        out.open("xs:schema", "xmlns:t", SoapNamespaces.TYPES, "targetNamespace", SoapNamespaces.URI);
        out.empty("xs:import", "namespace", SoapNamespaces.TYPES);
        for (SoapOperation operation : service.operations()) {
            element(schema, operation.name(), operation.elements());
            element(schema, operation.name() + "Response", answer(operation));
        }
        out.empty("xs:element", "name", FAULT, "type", XmlSchemaWriter.PREFIX + ":" + PROBLEM);
        out.close().close();
    }

    private static XmlMember fault() {
        return new XmlMember(FAULT, new XmlType.Named(PROBLEM), true, false, "");
    }

    private void element(XmlSchemaWriter schema, String name, List<XmlMember> members) {
        out.open("xs:element", "name", name).open("xs:complexType");
        schema.sequence(members);
        out.close().close();
    }

    private static List<XmlMember> answer(SoapOperation operation) {
        SoapOperation.Answer answer = operation.answer();
        return answer == null
                ? List.of()
                : List.of(new XmlMember(RETURN, answer.type(), !answer.nullable(), answer.nullable(), ""));
    }

    private void message(String name, String element) {
        out.open("wsdl:message", "name", name)
                .empty("wsdl:part", "name", name.equals(FAULT) ? FAULT : "parameters", "element", "tns:" + element)
                .close();
    }

    private void portType() {
        out.open("wsdl:portType", "name", service.portType());
        for (SoapOperation operation : service.operations()) {
            out.open("wsdl:operation", "name", operation.name());
            out.leaf("wsdl:documentation", operation.words());
            javaName(operation.name());
            out.empty("wsdl:input", "message", "tns:" + operation.name());
            out.empty("wsdl:output", "message", "tns:" + operation.name() + "Response");
            out.empty("wsdl:fault", "name", FAULT, "message", "tns:" + FAULT);
            out.close();
        }
        out.close();
    }

    /** The paper has an operation that no method in Java can be called as. */
    private void javaName(String operation) {
        if (SourceVersion.isKeyword(operation)) {
            for (String tools : JAVA_TOOLS) {
                out.open("jaxws:bindings", "xmlns:jaxws", tools)
                        .empty("jaxws:method", "name", operation + "Place")
                        .close();
            }
        }
    }

    private String portName(String version) {
        return version.equals(SOAP_11) ? service.port() : service.port() + "12";
    }

    private String bindingName(String version) {
        return portName(version) + "Binding";
    }

    private void binding(String version) {
        out.open("wsdl:binding", "name", bindingName(version), "type", "tns:" + service.portType());
        out.empty(version + ":binding", "style", "document", "transport", "http://schemas.xmlsoap.org/soap/http");
        for (SoapOperation operation : service.operations()) {
            out.open("wsdl:operation", "name", operation.name());
            out.empty(version + ":operation", "soapAction", "", "style", "document");
            out.open("wsdl:input").empty(version + ":body", "use", "literal").close();
            out.open("wsdl:output").empty(version + ":body", "use", "literal").close();
            out.open("wsdl:fault", "name", FAULT)
                    .empty(version + ":fault", "name", FAULT, "use", "literal")
                    .close();
            out.close();
        }
        out.close();
    }

    private void port(String version, String address) {
        out.open("wsdl:port", "name", portName(version), "binding", "tns:" + bindingName(version))
                .empty(version + ":address", "location", address)
                .close();
    }
}
