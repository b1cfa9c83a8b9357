package org.dronemap.ws.soap;

import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.interceptor.StaxInInterceptor;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;

/** Rejects SOAP messages with a DOCTYPE before any of their XML is parsed. */
final class DoctypeRejectionInterceptor extends AbstractPhaseInterceptor<Message> {
    DoctypeRejectionInterceptor() {
        super(Phase.POST_STREAM);
        addAfter(StaxInInterceptor.class.getName());
    }

    @Override
    public void handleMessage(Message message) throws Fault {
        XMLStreamReader reader = message.getContent(XMLStreamReader.class);
        if (reader == null) {
            return;
        }
        try {
            while (reader.getEventType() != XMLStreamConstants.START_ELEMENT) {
                if (reader.getEventType() == XMLStreamConstants.DTD) {
                    throw UndispatchedFaultInterceptor.unreadable("A SOAP message must not have a DOCTYPE.");
                }
                if (!reader.hasNext()) {
                    return;
                }
                reader.next();
            }
        } catch (XMLStreamException e) {
            throw UndispatchedFaultInterceptor.unreadable("This is not well-formed XML.");
        }
    }
}
