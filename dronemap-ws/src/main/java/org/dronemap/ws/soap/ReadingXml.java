package org.dronemap.ws.soap;

import javax.xml.stream.XMLStreamReader;
import org.apache.cxf.interceptor.StaxInInterceptor;
import org.apache.cxf.message.Message;
import org.apache.cxf.phase.AbstractPhaseInterceptor;
import org.apache.cxf.phase.Phase;

/** Puts a reader before the parser that can tell where in the message it is. */
final class ReadingXml extends AbstractPhaseInterceptor<Message> {
    ReadingXml() {
        super(Phase.POST_STREAM);
        addAfter(StaxInInterceptor.class.getName());
        addAfter(NoDoctype.class.getName());
    }

    @Override
    public void handleMessage(Message message) {
        XMLStreamReader reader = message.getContent(XMLStreamReader.class);
        if (reader != null && reader.isStartElement()) {
            Whereabouts whereabouts = new Whereabouts(reader);
            message.setContent(XMLStreamReader.class, whereabouts);
            message.getExchange().put(Whereabouts.class, whereabouts);
        }
    }
}
