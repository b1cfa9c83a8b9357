package org.dronemap.ws.soap;

import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import javax.xml.transform.dom.DOMResult;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.staxutils.StaxUtils;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.dronemap.ws.soap.xml.JsonToXml;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import tools.jackson.databind.JsonNode;

/** Makes faults of problems: REST's sentence, and all its members as the detail. */
final class SoapFaultFactory {
    private static final int FIRST_OWN_FAULT = 500;

    private SoapFaultFactory() {}

    /** {@code problem}: as REST answers it. */
    static SoapFault of(JsonNode problem, XmlTypes types) {
        boolean own = problem.path("status").asInt(FIRST_OWN_FAULT) >= FIRST_OWN_FAULT;
        SoapFault fault = new SoapFault(
                problem.path("detail").asString("The request was refused."),
                own ? Fault.FAULT_CODE_SERVER : Fault.FAULT_CODE_CLIENT);
        try {
            fault.setDetail(detail(problem, types));
        } catch (XMLStreamException | ParserConfigurationException e) {
            throw new IllegalStateException(e);
        }
        return fault;
    }

    private static Element detail(JsonNode problem, XmlTypes types)
            throws XMLStreamException, ParserConfigurationException {
        Document document =
                DocumentBuilderFactory.newInstance().newDocumentBuilder().newDocument();
        document.appendChild(document.createElement("detail"));
        XMLStreamWriter out = StaxUtils.createXMLStreamWriter(new DOMResult(document.getDocumentElement()));
        out.writeStartElement(WsdlWriter.PREFIX, WsdlWriter.FAULT, SoapNamespaces.URI);
        out.writeNamespace(WsdlWriter.PREFIX, SoapNamespaces.URI);
        new JsonToXml(types).members(out, types.structure(WsdlWriter.PROBLEM), problem);
        out.writeEndElement();
        out.flush();
        return document.getDocumentElement();
    }
}
