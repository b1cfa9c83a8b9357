package org.dronemap.ws.soap;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.util.Base64;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import javax.xml.transform.Source;
import javax.xml.transform.stream.StreamSource;
import org.apache.cxf.staxutils.StaxUtils;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Makes the message that answers a call from what REST answered. */
final class AnswerMessage {
    private final XmlTypes types;
    private final JsonMapper mapper;

    AnswerMessage(XmlTypes types, JsonMapper mapper) {
        this.types = types;
        this.mapper = mapper;
    }

    Source of(SoapOperation operation, RestAnswer answer) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try {
            XMLStreamWriter out = StaxUtils.createXMLStreamWriter(bytes);
            out.writeStartElement(Wsdl.PREFIX, operation.name() + "Response", Namespace.URI);
            out.writeNamespace(Wsdl.PREFIX, Namespace.URI);
            content(out, operation.answer(), answer);
            out.writeEndElement();
            out.flush();
        } catch (XMLStreamException e) {
            throw new IllegalStateException(
                    "what REST answered to " + operation.of().id() + " cannot be written", e);
        }
        return new StreamSource(new ByteArrayInputStream(bytes.toByteArray()));
    }

    private void content(XMLStreamWriter out, SoapOperation.@Nullable Answer described, RestAnswer answer)
            throws XMLStreamException {
        byte[] body = answer.getContentAsByteArray();
        if (described == null || body.length == 0) {
            return;
        }
        if (described.json()) {
            JsonNode value = mapper.readTree(body);
            new JsonToXml(types).write(out, Wsdl.RETURN, described.type(), value);
        } else {
            out.writeStartElement(Wsdl.RETURN);
            out.writeCharacters(Base64.getEncoder().encodeToString(body));
            out.writeEndElement();
        }
    }
}
