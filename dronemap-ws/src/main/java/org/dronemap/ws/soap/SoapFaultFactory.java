package org.dronemap.ws.soap;

import java.io.StringReader;
import java.util.List;
import java.util.Objects;
import javax.xml.stream.XMLStreamException;
import org.apache.cxf.binding.soap.SoapFault;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.staxutils.StaxUtils;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.dronemap.ws.soap.xml.XmlGenerator;
import org.dronemap.ws.soap.xml.XmlType;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.w3c.dom.Element;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Makes a SOAP fault of a problem that REST answered: its sentence, and its members as the detail. */
final class SoapFaultFactory {
    private static final int FIRST_OWN_FAULT = 500;

    private SoapFaultFactory() {}

    /** {@code problem}: as REST answers it. */
    static SoapFault of(JsonNode problem, JsonMapper mapper, XmlTypes types) {
        boolean own = problem.path("status").asInt(FIRST_OWN_FAULT) >= FIRST_OWN_FAULT;
        SoapFault fault = new SoapFault(
                problem.path("detail").asString("The request was refused."),
                own ? Fault.FAULT_CODE_SERVER : Fault.FAULT_CODE_CLIENT);
        fault.setDetail(detail(problem, mapper, types));
        return fault;
    }

    private static Element detail(JsonNode problem, JsonMapper mapper, XmlTypes types) {
        String tag = WsdlWriter.PREFIX + ":" + WsdlWriter.FAULT + " xmlns:" + WsdlWriter.PREFIX + "=\""
                + SoapNamespaces.URI + "\"";
        List<String> xml = XmlGenerator.write(
                mapper, types, tag, new XmlType.Named(WsdlWriter.PROBLEM), problem, RestResponse.LONGEST_BYTES);
        try {
            return StaxUtils.read(
                            new StringReader("<detail>" + String.join("", Objects.requireNonNull(xml)) + "</detail>"))
                    .getDocumentElement();
        } catch (XMLStreamException e) {
            throw new IllegalStateException(e);
        }
    }
}
