package org.dronemap.ws.soap;

import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import javax.xml.stream.util.StreamReaderDelegate;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;

/** Limits attributes of XML elements in SOAP messages, which CXF does not. */
final class AttributeLimitInterceptor extends AbstractPhaseInterceptor<Message> {
    private static final int MOST = 50;

    AttributeLimitInterceptor() {
        super(Phase.POST_STREAM);
        addAfter(DoctypeRejectionInterceptor.class.getName());
    }

    @Override
    public void handleMessage(Message message) {
        XMLStreamReader reader = message.getContent(XMLStreamReader.class);
        if (reader != null && reader.isStartElement()) {
            message.setContent(XMLStreamReader.class, new Bounded(reader));
        }
    }

    private static final class Bounded extends StreamReaderDelegate {
        Bounded(XMLStreamReader reader) {
            super(reader);
        }

        @Override
        public int next() throws XMLStreamException {
            int event = super.next();
            if (event == START_ELEMENT && getAttributeCount() > MOST) {
                throw UndispatchedFaultInterceptor.unreadable("An element may have at most " + MOST + " attributes.");
            }
            return event;
        }
    }
}
