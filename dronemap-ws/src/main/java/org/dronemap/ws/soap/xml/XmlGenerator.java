package org.dronemap.ws.soap.xml;

import java.math.BigDecimal;
import java.math.BigInteger;
import java.util.Arrays;
import java.util.List;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.Base64Variant;
import tools.jackson.core.ErrorReportConfiguration;
import tools.jackson.core.JsonEncoding;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.StreamWriteCapability;
import tools.jackson.core.StreamWriteConstraints;
import tools.jackson.core.TokenStreamContext;
import tools.jackson.core.Version;
import tools.jackson.core.base.GeneratorBase;
import tools.jackson.core.io.ContentReference;
import tools.jackson.core.io.IOContext;
import tools.jackson.core.io.NumberOutput;
import tools.jackson.core.util.BufferRecycler;
import tools.jackson.core.util.JacksonFeatureSet;
import tools.jackson.core.util.SimpleStreamWriteContext;
import tools.jackson.databind.json.JsonMapper;

/** Jackson generator that writes any value as XML elements of a SOAP message, by their described types. */
public final class XmlGenerator extends GeneratorBase {
    private static final String STRING = "string";
    private static final String NUMBER = "number";

    private final XmlElementWriter out;
    private final JsonMapper mapper;
    private SimpleStreamWriteContext context = SimpleStreamWriteContext.createRootContext(null);

    private XmlGenerator(XmlElementWriter out, JsonMapper mapper) {
        super(
                ObjectWriteContext.empty(),
                new IOContext(
                        StreamReadConstraints.defaults(),
                        StreamWriteConstraints.defaults(),
                        ErrorReportConfiguration.defaults(),
                        new BufferRecycler(),
                        ContentReference.unknown(),
                        false,
                        JsonEncoding.UTF8),
                0);
        this.out = out;
        this.mapper = mapper;
    }

    /**
     * The element of a value, which Jackson can write as JSON, in parts; null: it is longer.
     *
     * @param tag its name, and what else stands in its tag
     * @param longest characters
     */
    public static @Nullable List<String> write(
            JsonMapper mapper, XmlTypes types, String tag, XmlType type, Object value, int longest) {
        XmlElementWriter out = new XmlElementWriter(types, tag, type, longest);
        try (XmlGenerator generator = new XmlGenerator(out, mapper)) {
            mapper.writeValue(generator, value);
        }
        return out.isTooLong() ? null : out.text();
    }

    @Override
    public JsonGenerator writeStartArray() {
        return writeStartArray(null);
    }

    @Override
    public JsonGenerator writeStartArray(@Nullable Object value) {
        context = context.createChildArrayContext(value);
        out.start();
        return this;
    }

    @Override
    public JsonGenerator writeEndArray() {
        return end();
    }

    @Override
    public JsonGenerator writeStartObject() {
        return writeStartObject(null);
    }

    @Override
    public JsonGenerator writeStartObject(@Nullable Object value) {
        context = context.createChildObjectContext(value);
        out.start();
        return this;
    }

    @Override
    public JsonGenerator writeEndObject() {
        return end();
    }

    private JsonGenerator end() {
        context = context.clearAndGetParent();
        out.end();
        return this;
    }

    @Override
    public JsonGenerator writeName(String name) {
        context.writeName(name);
        out.name(name);
        return this;
    }

    @Override
    public JsonGenerator writePropertyId(long id) {
        return writeName(Long.toString(id));
    }

    @Override
    public JsonGenerator writeString(@Nullable String value) {
        return value == null ? writeNull() : value(value, STRING);
    }

    @Override
    public JsonGenerator writeString(char[] letters, int from, int length) {
        return value(new String(letters, from, length), STRING);
    }

    @Override
    public JsonGenerator writeBinary(Base64Variant variant, byte[] bytes, int from, int length) {
        byte[] some = from == 0 && length == bytes.length ? bytes : Arrays.copyOfRange(bytes, from, from + length);
        return value(variant.encode(some), STRING);
    }

    @Override
    public JsonGenerator writeNumber(short value) {
        return writeNumber((long) value);
    }

    @Override
    public JsonGenerator writeNumber(int value) {
        return writeNumber((long) value);
    }

    @Override
    public JsonGenerator writeNumber(long value) {
        return value(Long.toString(value), NUMBER);
    }

    @Override
    public JsonGenerator writeNumber(BigInteger value) {
        return value(value.toString(), NUMBER);
    }

    @Override
    public JsonGenerator writeNumber(double value) {
        return value(NumberOutput.toString(value, false), NUMBER);
    }

    @Override
    public JsonGenerator writeNumber(float value) {
        return value(NumberOutput.toString(value, false), NUMBER);
    }

    @Override
    public JsonGenerator writeNumber(BigDecimal value) {
        return value(value.toString(), NUMBER);
    }

    @Override
    public JsonGenerator writeNumber(String encoded) {
        return value(encoded, NUMBER);
    }

    @Override
    public JsonGenerator writeBoolean(boolean value) {
        return value(Boolean.toString(value), "boolean");
    }

    private JsonGenerator value(String value, String kind) {
        context.writeValue();
        out.value(value, kind);
        return this;
    }

    @Override
    public JsonGenerator writeNull() {
        context.writeValue();
        out.nil();
        return this;
    }

    /** Reads a value that is JSON already, and writes it. */
    @Override
    public JsonGenerator writeRawValue(String json) {
        try (JsonParser parser = mapper.createParser(json)) {
            parser.nextToken();
            copyCurrentStructure(parser);
        }
        return this;
    }

    @Override
    public JsonGenerator writeRawUTF8String(byte[] bytes, int from, int length) {
        throw json();
    }

    @Override
    public JsonGenerator writeUTF8String(byte[] bytes, int from, int length) {
        throw json();
    }

    @Override
    public JsonGenerator writeRaw(String text) {
        throw json();
    }

    @Override
    public JsonGenerator writeRaw(String text, int from, int length) {
        throw json();
    }

    @Override
    public JsonGenerator writeRaw(char[] text, int from, int length) {
        throw json();
    }

    @Override
    public JsonGenerator writeRaw(char letter) {
        throw json();
    }

    private static UnsupportedOperationException json() {
        return new UnsupportedOperationException("parts of JSON cannot be written as XML");
    }

    @Override
    public TokenStreamContext streamWriteContext() {
        return context;
    }

    @Override
    public @Nullable Object currentValue() {
        return context.currentValue();
    }

    @Override
    public void assignCurrentValue(Object value) {
        context.assignCurrentValue(value);
    }

    @Override
    public JacksonFeatureSet<StreamWriteCapability> streamWriteCapabilities() {
        return DEFAULT_TEXTUAL_WRITE_CAPABILITIES;
    }

    @Override
    public Object streamWriteOutputTarget() {
        return out;
    }

    @Override
    public int streamWriteOutputBuffered() {
        return 0;
    }

    @Override
    public Version version() {
        return Version.unknownVersion();
    }

    @Override
    public void flush() {
        // All that is written is where it belongs.
    }

    @Override
    protected void _closeInput() {
        // Nothing is open.
    }

    @Override
    protected void _releaseBuffers() {
        // It has none.
    }

    @Override
    protected void _verifyValueWrite(String what) {
        context.writeValue();
    }
}
