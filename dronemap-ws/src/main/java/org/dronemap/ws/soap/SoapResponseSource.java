package org.dronemap.ws.soap;

import java.io.StringReader;
import java.util.Base64;
import java.util.List;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import javax.xml.transform.Source;
import org.apache.cxf.staxutils.StaxUtils;
import org.codehaus.stax2.XMLStreamWriter2;
import org.dronemap.ws.soap.description.WsdlWriter;
import org.dronemap.ws.soap.xml.SoapNamespaces;
import org.jspecify.annotations.Nullable;

/**
 * The body of the SOAP message that answers a call, made of what REST answered. It is written at once where it goes, by
 * {@link SoapResponseBinding}.
 */
final class SoapResponseSource implements Source {
    private final String operation;
    private final @Nullable List<String> xml;
    private final byte[] file;

    /** {@code xml}: its only element, in parts; null: that has the file's bytes, and there is none without any. */
    SoapResponseSource(String operation, @Nullable List<String> xml, byte[] file) {
        this.operation = operation;
        this.xml = xml;
        this.file = file;
    }

    void write(XMLStreamWriter out) throws XMLStreamException {
        out.writeStartElement(WsdlWriter.PREFIX, operation + "Response", SoapNamespaces.URI);
        out.writeNamespace(WsdlWriter.PREFIX, SoapNamespaces.URI);
        if (xml != null) {
            write(out, xml);
        } else if (file.length > 0) {
            out.writeStartElement(WsdlWriter.RETURN);
            out.writeCharacters(Base64.getEncoder().encodeToString(file));
            out.writeEndElement();
        }
        out.writeEndElement();
    }

    private static void write(XMLStreamWriter out, List<String> xml) throws XMLStreamException {
        if (out instanceof XMLStreamWriter2 quick) {
            for (String part : xml) {
                quick.writeRaw(part);
            }
        } else {
            StaxUtils.copy(StaxUtils.createXMLStreamReader(new StringReader(String.join("", xml))), out);
        }
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
