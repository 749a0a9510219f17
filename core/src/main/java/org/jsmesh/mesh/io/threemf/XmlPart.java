package org.jsmesh.mesh.io.threemf;

import java.io.ByteArrayInputStream;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * The elements of an XML part, one after the other. There are no document types and no entities but the five of XML, so
 * that nothing is fetched and nothing grows; elements are nested to a limit.
 */
final class XmlPart {
    static final int DEEPEST = 64;

    private static final String NO_XML = "Export the model anew";

    private final String path;
    private final XMLStreamReader reader;
    private int depth;

    XmlPart(String path, byte[] content) throws ThreeMfException {
        this.path = path;
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_REPLACING_ENTITY_REFERENCES, false);
        try {
            reader = factory.createXMLStreamReader(new ByteArrayInputStream(content));
        } catch (XMLStreamException e) {
            throw new ThreeMfException(path, "it is no XML", NO_XML);
        }
    }

    /** Goes to the start of the next element; false at the end of the enclosing element, or of the part. */
    boolean next() throws ThreeMfException {
        try {
            while (reader.hasNext()) {
                int event = reader.next();
                if (event == XMLStreamConstants.DTD || event == XMLStreamConstants.ENTITY_REFERENCE)
                    throw error("a document type or an entity, which 3MF does not allow", NO_XML);
                if (event == XMLStreamConstants.START_ELEMENT) {
                    if (++depth > DEEPEST) throw error("elements are nested more than " + DEEPEST + " deep", NO_XML);
                    return true;
                }
                if (event == XMLStreamConstants.END_ELEMENT) {
                    depth--;
                    return false;
                }
            }
            return false;
        } catch (XMLStreamException | RuntimeException e) {
            throw error("the XML is damaged or cut off", NO_XML);
        }
    }

    /** Skips what is in the current element. */
    void skip() throws ThreeMfException {
        int open = 1;
        while (open > 0) open += next() ? 1 : -1;
    }

    String name() {
        return reader.getLocalName();
    }

    String namespace() {
        String uri = reader.getNamespaceURI();
        return uri == null ? "" : uri;
    }

    /** What a prefix stands for here, or null. */
    String namespaceOf(String prefix) {
        return reader.getNamespaceURI(prefix);
    }

    /** Null when there is none. */
    String attribute(String attribute) {
        String own = reader.getAttributeValue("", attribute);
        return own == null ? reader.getAttributeValue(null, attribute) : own;
    }

    /** Null when there is none. */
    String attribute(String uri, String attribute) {
        return reader.getAttributeValue(uri, attribute);
    }

    int whole(String attribute, int otherwise) throws ThreeMfException {
        String text = attribute(attribute);
        return text == null ? otherwise : parse(attribute, text);
    }

    int whole(String attribute) throws ThreeMfException {
        return parse(attribute, required(attribute));
    }

    private int parse(String attribute, String text) throws ThreeMfException {
        try {
            int value = Integer.parseInt(text.strip());
            if (value >= 0) return value;
        } catch (NumberFormatException e) {
            // told below
        }
        throw error(attribute + " is " + quote(text) + ", not a whole number in range", "Correct this line");
    }

    String required(String attribute) throws ThreeMfException {
        String text = attribute(attribute);
        if (text == null) throw error(name() + " has no " + attribute, "Correct this line");
        return text;
    }

    double number(String attribute) throws ThreeMfException {
        return number(attribute, required(attribute));
    }

    double number(String what, String text) throws ThreeMfException {
        try {
            double value = Double.parseDouble(text);
            // Java's own suffixes and hexadecimal numbers are no numbers of XML
            char last = text.isBlank() ? ' ' : text.strip().charAt(text.strip().length() - 1);
            boolean plain =
                    (last >= '0' && last <= '9' || last == '.') && text.indexOf('x') < 0 && text.indexOf('X') < 0;
            if (Float.isFinite((float) value) && plain) return value;
        } catch (NumberFormatException e) {
            // told below
        }
        throw error(
                what + " is " + quote(text) + ", not a finite number",
                "Repair or remove it in the program that wrote the file");
    }

    ThreeMfException error(String reason, String remedy) {
        return new ThreeMfException(path + ", line " + reader.getLocation().getLineNumber(), reason, remedy);
    }

    static String quote(String text) {
        return '"' + PackageNotes.shown(text) + '"';
    }
}
