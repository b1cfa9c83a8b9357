package org.dronemap.ws.soap;

import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.apache.cxf.databinding.DataWriter;
import org.apache.cxf.databinding.source.SourceDataBinding;
import org.apache.cxf.databinding.source.XMLStreamDataWriter;
import org.apache.cxf.interceptor.Fault;
import org.apache.cxf.service.model.MessagePartInfo;
import org.jspecify.annotations.Nullable;

/** CXF data binding that streams SOAP answers without building a copy in memory. */
final class SoapResponseBinding extends SourceDataBinding {
    @Override
    @SuppressWarnings("unchecked") // it is asked for a writer to exactly this
    public <T> DataWriter<T> createWriter(Class<T> kind) {
        return kind == XMLStreamWriter.class ? (DataWriter<T>) new ResponseWriter() : super.createWriter(kind);
    }

    private static final class ResponseWriter extends XMLStreamDataWriter {
        @Override
        public void write(@Nullable Object message, @Nullable MessagePartInfo part, XMLStreamWriter out) {
            if (!(message instanceof SoapResponseSource answer)) {
                super.write(message, part, out);
                return;
            }
            try {
                answer.write(out);
            } catch (XMLStreamException e) {
                throw new Fault(e);
            }
        }
    }
}
