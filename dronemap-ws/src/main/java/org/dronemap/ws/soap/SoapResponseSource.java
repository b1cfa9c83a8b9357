package org.dronemap.ws.soap;

import java.util.Base64;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import javax.xml.transform.Source;
import org.dronemap.ws.soap.description.SoapOperation;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.dronemap.ws.soap.xml.JsonToXml;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.dronemap.ws.soap.xml.XmlTypes;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The message that answers a call, made of what REST answered. It is written at once where it goes, by {@link SoapResponseBinding}. */
final class SoapResponseSource implements Source {
    private final XmlTypes types;
    private final SoapOperation operation;
    private final byte[] body;
    private final @Nullable JsonNode value;

    private SoapResponseSource(XmlTypes types, SoapOperation operation, byte[] body, @Nullable JsonNode value) {
        this.types = types;
        this.operation = operation;
        this.body = body;
        this.value = value;
    }

    static SoapResponseSource of(XmlTypes types, JsonMapper mapper, SoapOperation operation, RestResponse answer) {
        SoapOperation.Answer described = operation.answer();
        byte[] body = described == null ? new byte[0] : answer.getContentAsByteArray();
        boolean json = described != null && described.json() && body.length > 0;
        return new SoapResponseSource(types, operation, body, json ? mapper.readTree(body) : null);
    }

    void write(XMLStreamWriter out) throws XMLStreamException {
        out.writeStartElement(WsdlWriter.PREFIX, operation.name() + "Response", SoapNamespaces.URI);
        out.writeNamespace(WsdlWriter.PREFIX, SoapNamespaces.URI);
        SoapOperation.Answer described = operation.answer();
        if (described != null && value != null) {
            new JsonToXml(types).write(out, WsdlWriter.RETURN, described.type(), value);
        } else if (body.length > 0) {
            out.writeStartElement(WsdlWriter.RETURN);
            out.writeCharacters(Base64.getEncoder().encodeToString(body));
            out.writeEndElement();
        }
        out.writeEndElement();
    }

    @Override
    public @Nullable String getSystemId() {
        return null;
    }

    @Override
    public void setSystemId(String systemId) {
        // It comes from nowhere that has one.
    }
}
