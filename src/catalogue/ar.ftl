# نصوص الرسائل بالعربية. أسماء المداخل ومتغيراتها كما في en.ftl، وجدول المصطلحات في docs/terms.md.

## Errors. They follow `error: ` or stand in a sentence.

error-invalid-option =
    { $got ->
        [none] ‏{ $field } غير معطى
       *[other] قيمة { $field } هي { $got }
    }؛ المسموح: { $allowed }
error-invalid-json = { $document }: { $json_fault }
error-invalid-input = { $refusal }
error-unreadable-image = تعذرت قراءة الصورة: { $image_fault }
error-unsupported-image = { $unsupported }
error-too-many-pixels = تعلن الصورة عن { $width } × { $height } بكسل = { FIXED($megapixels, digits: 1) } ميغابكسل؛ المسموح: حتى { FIXED($max_megapixels, digits: 1) } ميغابكسل
error-too-much-memory = تحتاج صورة من { $width } × { $height } بكسل إلى نحو { $needed_mb } ميغابايت من الذاكرة؛ المسموح: حتى { $max_mb } ميغابايت
error-image-too-small = أبعاد الصورة { $width } × { $height } بكسل؛ يحتاج { $image_operation } إلى { $min_side } بكسل على الأقل في كل ضلع
error-window-outside = النافذة ذات { $side } × { $side } بكسل عند العمود { $col } والصف { $row } تخرج عن الصورة ذات { $width } × { $height } بكسل
error-constant-window = النافذة ذات { $side } × { $side } بكسل عند العمود { $col } والصف { $row } ثابتة القيم: لا عزوم لها
error-too-few = { $few }: أُعطي { $got }؛ المطلوب { $needed } على الأقل
error-degenerate = الأرصاد لا تحدد { $computation }: { $cause }
error-undetermined-image = { $computation } لا يحدد الصورة { $image } (العد من 0): { $cause }
error-not-converged = { $computation } لا يتقارب في { $iterations } من التكرارات: { $cause }
error-not-exportable = لا يمكن تصدير هذه الصور بصيغة { $formats } ({ $error }): أعد تسميتها، أو اترك الصيغة التي لا تتسع لأسمائها
error-interrupted = لا يمكن متابعة التشغيل: { $interruption }
error-unreadable-file =
    تعذرت قراءة { $document }: { $file_place ->
        [none] {""}
       *[other] { $file_place }:{" "}
    }{ $file_fault }
error-not-written = تعذرت كتابة { $document }: لا يقبل المخرج نصًا آخر
error-not-loaded = لم تُحمَّل الوحدة: استدعِ load()، وهي التصدير الافتراضي لـ tiepoint، وانتظرها أولًا

json-fault-value =
    { $field ->
        [none] {""}
       *[other] { $field }:{" "}
    }{ $json_slip }{ $line ->
        [none] {""}
       *[other] {" "}في السطر { $line } والعمود { $column }
    }
json-fault-syntax =
    { $json_syntax }{ $line ->
        [none] {""}
       *[other] {" "}في السطر { $line } والعمود { $column }
    }
json-fault-field =
    { $field }: { $words }{ $line ->
        [none] {""}
       *[other] {" "}في السطر { $line } والعمود { $column }
    }
json-fault-text =
    { $words }{ $line ->
        [none] {""}
       *[other] {" "}في السطر { $line } والعمود { $column }
    }

json-slip-other-kind = أُعطي { $json_kind }؛ المسموح: { $json_wanted }
json-slip-other-value = أُعطي { $value }؛ المسموح: { $json_wanted }
json-slip-other-length =
    أُعطيت قائمة عدد عناصرها { $items }{ $wanted_items ->
        [none] {""}
       *[other] ؛ المسموح: قائمة عدد عناصرها { $wanted_items }
    }
json-slip-unknown-field =
    حقل غير معروف{ $known ->
        [none] {""}
       *[other] ؛ المسموح: { $known }
    }
json-slip-missing = غير موجود
json-slip-twice = أُعطي مرتين
json-slip-deep = قوائم وكائنات متداخلة؛ المسموح: حتى { $most } مستوى
json-slip-not-in-json = أُعطي { $value_kind }، وهو مما لا يوجد في JSON

json-wanted-of-kind = { $json_kind }
json-wanted-whole = أعداد صحيحة من { $min } إلى { $max }
json-wanted-match = رقم مطابقة، أو قائمة من أربعة أعداد هي موضعها
json-wanted-words = { $words }
json-wanted-other = قيمة أخرى

json-syntax-ended = ينتهي النص قبل أن تكتمل قيمته
json-syntax-continued = يتبع القيمةَ نص آخر
json-syntax-no-value = لا توجد قيمة حيث ينبغي أن تكون
json-syntax-no-name = اسم الحقل ليس بين علامتي اقتباس مزدوجتين
json-syntax-no-colon = لا توجد نقطتان رأسيتان بين اسم الحقل وقيمته
json-syntax-no-comma-in-list = لا توجد فاصلة ولا ] بعد عنصر من القائمة
json-syntax-no-comma-in-object = لا توجد فاصلة ولا {"}"} بعد حقل من الكائن
json-syntax-last-comma = توجد فاصلة بعد آخر عنصر أو حقل
json-syntax-number = عدد لم يُكتب كما تُكتب الأعداد في JSON
json-syntax-large-number = عدد أكبر من اللازم
json-syntax-escape = شرطة مائلة عكسية في نص يتبعها ما لا يجوز أن يتبعها
json-syntax-control-character = في النص فاصل أسطر أو محرف تحكم آخر
json-syntax-deep = قوائم وكائنات متداخلة أعمق من اللازم

json-kind-null = null
json-kind-boolean = نعم أو لا
json-kind-number = عدد
json-kind-text = نص
json-kind-list = قائمة
json-kind-object = كائن

allowed-integer =
    { $odd ->
        [true] أعداد صحيحة فردية
       *[false] أعداد صحيحة
    } من { $min } إلى { $max }
allowed-real = من { $min } إلى { $max }
allowed-flag = نعم أو لا
allowed-text = نص
allowed-object = كائن من الخيارات
allowed-words = { $words }
allowed-two-numbers =
    { $px ->
        [true] عددان بالبكسل
       *[false] عددان
    } من { $min } إلى { $max }
allowed-above-up-to = أكبر من { $above } وحتى { $max }
allowed-at-least = { $min } أو أكثر
allowed-but-zero = من { $min } إلى { $max }، ما عدا 0
allowed-unfolded = حدود بوحدات مم⁻² ومم⁻⁴ ومم⁻⁶ يزداد بها البعد عن النقطة الرئيسية حتى { FIXED($reach_mm, digits: 2) } مم حيث زوايا الصورة
allowed-finite =
    { $numbers ->
        [2] عددان منتهيان
        [3] ثلاثة أعداد منتهية
       *[other] { $numbers } من الأعداد المنتهية
    }
allowed-one-of-two = { $first } أو { $second }، لا كلاهما
allowed-odd-for-forstner = أضلاع فردية لمؤثر Förstner
allowed-without-fiducials = من { $min } إلى { $max } حيث لا توجد علامات إطارية
allowed-for-photo-coordinates = من { $min } إلى { $max } في الصيغ ذات الإحداثيات الصورية
allowed-photo-rows = حتى { FIXED($most, digits: 0) } بهذا العرض، حتى لا تتجاوز الصورة 100 ميغابكسل
allowed-photo-relief = من 0 إلى { $most_m } للصور، أي عُشر ارتفاع الطيران
allowed-height-above-buildings = { $least_m } أو أكثر، أو دون مبانٍ
allowed-small-images-of-tilted = قيمة تكفي كي تسقط كل أشعة الكاميرات المائلة بزاوية 24 درجة أو أشد انحدارًا: صور أصغر
allowed-small-pixels = قيمة صغيرة تكفي كي تسقط كل الأشعة بزاوية 24 درجة أو أشد انحدارًا
allowed-long-focal-length = قيمة كبيرة تكفي كي تسقط كل الأشعة، مع هذه الميول، بزاوية 24 درجة أو أشد انحدارًا
allowed-orthophoto-pixel = أكبر من { FIXED($above, digits: 3) }، حتى لا تتجاوز 100 ميغابكسل
allowed-height-over-ground =
    حتى { FIXED($most_m, digits: 0) } م، كي { $block ->
        [true] لا تُظهر الكتلة
       *[false] لا يُظهر المقطع
    } أكثر من { $longest_m } م من الأرض

few-agreeing-observations = أرصاد تتفق على توجيه نسبي
few-different-observations = أرصاد مختلفة للتوجيه النسبي
few-different-matches = مطابقات مختلفة لهندسة الصورتين
few-matches-for-fundamental-matrix = مطابقات للمصفوفة الأساسية
few-matches-for-homography = مطابقات للتحويل الإسقاطي
few-fiducial-marks = العلامات الإطارية
few-images-of-block = صور الكتلة
few-observations-of-point = أرصاد نقطة
few-observed-coordinates = النقاط أقل مما تتطلبه مجاهيل الصور والنقاط والكاميرات، بعدّ إحداثيات الصور
few-positions-for-datum = مواضع GNSS أو نقاط ضبط أرضي برصدتين، للمرجع
few-control-points-for-datum = نقاط الضبط الأرضي، للمرجع
few-degrees-of-freedom = درجات الحرية، للتباينات المشتركة
few-intersected-points = نقاط متقاطعة، لارتفاعات الأرض
few-links = النقاط المشاركة التي تربط بالصورة المصححة

document-named = { $name }
document-block = الكتلة
document-camera = الكاميرا
document-cameras = الكاميرات
document-export = ملف التصدير
document-file = ملف
document-folder = المجلد
document-geo-tiff = ‏GeoTIFF
document-heights = نموذج الارتفاعات
document-kept-record = سجل محفوظ
document-orthophoto = الصورة المصححة
document-project = ملف المشروع
document-task = مهمة التشغيل

file-place-path = { $path }
file-place-line = السطر { $line }
file-place-byte = البايت { $byte }
file-place-length = الطول
file-place-checksum = المجموع الاختباري
file-place-content = المحتوى

image-operation-forstner-window = مؤثر Förstner بنافذته
image-operation-ground-operator = مؤثر Ground
image-operation-moravec-window = مؤثر Moravec بنافذته
image-operation-placing-on-orthophoto = الوضع على صورة مصححة
image-operation-pyramid-of-scales = هرم المقاييس

image-fault-empty = الملف فارغ
image-fault-damaged = { $format }: { $damage }
image-fault-mask = قناعها { $name }: { $error }

## Where an image contradicts its format. They follow the name of the format.

damage-decoder = { $words }
damage-truncated = ينتهي الملف قبل صورته: هو مبتور
damage-too-short = هو مبتور: تشغل { $width } × { $height } بكسل ما لا يقل عن { $least_bytes } بايت، وفي الملف { $bytes }
damage-no-pixels = يعلن عن { $width } × { $height } بكسل؛ وفي الضلع بكسل واحد على الأقل
damage-beyond-addresses = حجمه يتجاوز كل العناوين
damage-two-sizes = يعلن عن حجمين
damage-other-than-header = أعطى فاك الترميز حجمًا غير ما تعلنه الترويسة
damage-other-than-directory = أعطى فاك الترميز حجمًا غير ما يعلنه الدليل
damage-unknown-pam-line = في ترويسة PAM سطر غير معروف
damage-incomplete-pam-header = تنقص ترويسة PAM ‏WIDTH أو HEIGHT أو MAXVAL أو DEPTH من 1 إلى 4
damage-long-header = في ترويسته أكثر من { $most_bytes } بايت
damage-no-number = في ترويسته '{ $word }' حيث ينبغي عدد
damage-other-canvas = لوحته ({ $canvas }) بكسل تحوي إطارًا ({ $frame }) بكسل
damage-segment-length = طول المقطع ذي الواسم { HEX($marker, digits: 2) } هو { $length }
damage-unexpected-marker = فيه الواسم غير المتوقع { HEX($marker, digits: 2) }
damage-no-frame-header = تأتي بيانات صورته قبل ترويسة إطاره
damage-two-frame-headers = فيه ترويستا إطار
damage-frame-header-length = طول ترويسة إطاره لا يوافق مركباته
damage-restart-interval = فاصل إعادة البدء مبتور
damage-restart-markers = فيه { $markers } من { $expected } من واسمات إعادة البدء، أو ليست مرتبة: تنقصه بيانات
damage-short-scan = ينتهي مسح قبل الصورة: تنقصه بيانات
damage-no-image-data = ينتهي قبل بيانات صورته
damage-no-width = لا يعلن عن عرضه
damage-no-height = لا يعلن عن ارتفاعه
damage-two-directory-sizes = يعلن دليله عن حجمين
damage-many-tags = في دليله { $tags } من الوسوم؛ يُقرأ حتى { $most }
damage-many-values = في الوسم { $tag } من القيم { $values }؛ يُقرأ حتى { $most }
damage-colour-map = ليست في خريطة ألوانه 3 × 256 مدخلًا

## Kinds of files that are not decoded, and what to make of them.

file-kind-heic = صور HEIC لا تُقرأ: صدّرها بصيغة JPEG (وعلى iPhone للصور الجديدة: الإعدادات، الكاميرا، التنسيقات، الأكثر توافقًا)
file-kind-avif = صور AVIF لا تُقرأ: احفظها بصيغة JPEG أو PNG
file-kind-jpeg-xl = صور JPEG XL لا تُقرأ: احفظها بصيغة JPEG أو PNG
file-kind-jpeg2000 = صور JPEG 2000 لا تُقرأ: احفظها بصيغة TIFF (ويُبقي gdal_translate in.jp2 out.tif على مواضعها)
file-kind-ecw = صور ECW لا تُقرأ: احفظها بصيغة GeoTIFF (ويُبقي gdal_translate أو QGIS على مواضعها)
file-kind-mr-sid = صور MrSID لا تُقرأ: احفظها بصيغة GeoTIFF (ويُبقي gdal_translate أو QGIS على مواضعها)
file-kind-camera-raw = الصور الخام للكاميرات ({ $ending }) لا تُقرأ: حوّلها إلى JPEG أو TIFF، بحجمها الكامل ودون اقتصاص
file-kind-photoshop = مستندات Photoshop لا تُقرأ: احفظها بصيغة TIFF أو PNG
file-kind-gif = صور GIF لا تُقرأ: احفظها بصيغة PNG
file-kind-pdf = مستندات PDF لا تُقرأ: صدّر صورها بصيغة TIFF أو PNG
file-kind-video = الأفلام لا تُقرأ: احفظ صورًا مفردة منها بصيغة JPEG أو PNG
file-kind-archive = الأرشيفات (ZIP و7z وRAR) لا تُقرأ: فُكّها وأعطِ الصور التي فيها

## What is not decoded.

unsupported-kind = { $file_kind }؛ المسموح: { $formats }
unsupported-file = هذا النوع من الملفات غير مدعوم؛ المسموح: { $formats }
unsupported-decoder = ملف { $format } هذا ({ $words }) غير مدعوم؛ المسموح: { $formats }
unsupported-tiff-decoder = ملف TIFF هذا ({ $words }) غير مدعوم؛ المسموح: رمادي وRGB من 8 أو 16 بت، في شرائط أو بلاطات
unsupported-samples = { $format } بعينات { $samples } غير مدعوم؛ المسموح: 8 أو 16 بت
unsupported-animated-webp = ‏WebP المتحرك غير مدعوم؛ المسموح: صور ثابتة
unsupported-jpeg-arithmetic = ‏JPEG بالترميز الحسابي (SOF{ $frame }) غير مدعوم؛ المسموح: JPEG أساسي أو موسع أو تدريجي بترميز هوفمان
unsupported-jpeg-lossless = ‏JPEG بلا فقد أو هرمي (SOF{ $frame }) غير مدعوم؛ المسموح: JPEG أساسي أو موسع أو تدريجي بترميز هوفمان
unsupported-jpeg-bits = ‏JPEG من { $bits } بت غير مدعوم؛ المسموح: JPEG من 8 بت
unsupported-jpeg-components = ‏JPEG من { $components } مركبات (4: CMYK) غير مدعوم؛ المسموح: JPEG رمادي أو ملون بثلاث مركبات
unsupported-jpeg-sampling = ‏JPEG بعوامل التعيين [{ $sampling }] غير مدعوم؛ المسموح: تعيين المركبة الأولى 1 أو 2 أو 4 مرات، وسائرها مرة واحدة
unsupported-jpeg-scans = ‏JPEG بأكثر من { $most } من المسوح غير مدعوم؛ المسموح: حتى { $most }
unsupported-jpeg-rgb-apart = ‏JPEG أساسي لـRGB ليست مسوحه مسحًا لكل مركبة غير مدعوم؛ المسموح: مسح واحد لجميع المركبات، أو مسح لكل مركبة
unsupported-jpeg-luma-apart = ‏JPEG أساسي بمسحين منفصلين للإضاءة ولمركبة لون غير مدعوم؛ المسموح: مسح واحد لجميع المركبات، أو مسح للإضاءة وحدها
unsupported-tiff-floats = ‏TIFF بعينات الفاصلة العائمة غير مدعوم؛ المسموح: أعداد صحيحة بلا إشارة من 8 أو 16 بت
unsupported-tiff-signed = ‏TIFF بعينات ذات إشارة أو غير معرَّفة غير مدعوم؛ المسموح: أعداد صحيحة بلا إشارة من 8 أو 16 بت
unsupported-tiff-bits = ‏TIFF من { $bits } بت للعينة غير مدعوم؛ المسموح: 8 أو 16 بت للعينة
unsupported-tiff-colours = ‏TIFF بالتفسير الضوئي { $photometric } و{ $samples } من العينات بقدر { $bits } بت غير مدعوم؛ المسموح: رمادي (0، 1)، وRGB (2) بثلاث عينات أو أكثر، ولوحة ألوان (3) من 8 بت
unsupported-tiff-compression =
    ‏TIFF بالضغط { $compression ->
        [50000] 50000 (ZSTD)
        [50001] 50001 (WebP)
        [34925] 34925 (LZMA)
        [34887] 34887 (LERC)
        [34712] 34712 (JPEG 2000)
       *[other] { $compression }
    } غير مدعوم؛ المسموح: بلا ضغط، LZW، JPEG، Deflate، PackBits (1، 5، 7، 8، 32946، 32773)، كما يكتبه gdal_translate -co COMPRESS=DEFLATE
unsupported-tiff-tile-side = ‏TIFF بضلع بلاطة أكبر من 65536 بكسل غير مدعوم؛ المسموح: حتى 65536 بكسل
unsupported-tiff-tile-row = ‏TIFF فيه { $bytes } بايت في صف بلاطة غير مدعوم؛ المسموح: حتى 16777216
unsupported-tiff-bands = ‏TIFF من { $bands } نطاقات مع متنبئ غير مدعوم؛ المسموح: 1 أو 3 أو 4 نطاقات (رابعها الشفافية)، أو بلا متنبئ

file-fault-system = { $message }
file-fault-not-text = ليس نصًا (UTF-8)
file-fault-content = { $json_fault }
file-fault-no-number = ‏{ $field } هو '{ $word }'، وليس عددًا منتهيًا
file-fault-no-whole-number = ‏{ $field } هو '{ $word }'، وليس عددًا صحيحًا من مجاله
file-fault-short-line = ينتهي قبل { $field }
file-fault-camera-again = تكررت الكاميرا { $camera }
file-fault-image-again = تكررت الصورة { $image }
file-fault-point-again = تكررت النقطة { $point }
file-fault-no-camera = الكاميرا { $camera } ليست في cameras.txt
file-fault-no-image = الصورة { $image } ليست في images.txt
file-fault-no-feature = ليس للصورة { $image } نقطة { $feature }
file-fault-camera-model = ‏{ $model } بعدد { $parameters } من المعاملات؛ المسموح: SIMPLE_PINHOLE وPINHOLE وSIMPLE_RADIAL وRADIAL وOPENCV وFULL_OPENCV ببعد بؤري واحد وحتى ثلاثة معاملات شعاعية
file-fault-zero-quaternion = الرباعي صفر
file-fault-after-name = ‏'{ $word }' بعد الاسم
file-fault-no-features = سطر نقاطه ناقص
file-fault-no-project = ليس مشروعًا من Tiepoint: سطره الأول '{ $line }'
file-fault-no-header = ليس مشروعًا من Tiepoint: سطره الأول '{ $line }' ({ $json_fault })
file-fault-other-format = صيغته '{ $format }' وليست '{ $wanted }'
file-fault-other-version = هو من الإصدار { $version }؛ يقرأ هذا البرنامج الإصدارات من 1 إلى { $newest }
file-fault-other-length = يلي السطر الأول { $bytes } بايت، وهو يعلن عن { $declared }: الملف مبتور أو غُيّر
file-fault-other-checksum = المجموع الاختباري في السطر الأول لا يوافق الباقي: الملف تالف أو غُيّر يدويًا
file-fault-holds-pair = يحوي زوجًا لا كتلة
file-fault-holds-block = يحوي كتلة لا زوجًا
file-fault-record-changed = أُزيل أو غُيّر أثناء التشغيل: أعد التشغيل
file-fault-in-use = يستعمله { $owner }: انتظر انتهاءه، أو أزل القفل إن لم تكن عملية كهذه جارية

interruption-image-changed = غُيّرت { $name } أثناء التشغيل: أعد التشغيل
interruption-unreadable-work = ناتج إحدى المهام لا يُقرأ كما كُتب
interruption-unfinished = أُنهي قبل اكتمال جميع مهامه
interruption-job = { $failure }
interruption-refinement = لا يمكن تدقيق أرصاد { $name }: { $failure }

## What is computed.

computation-affine-transformation = التحويل الأفيني
computation-bundle-adjustment = ضبط الحزم
computation-by-and-bz = المركبتان by وbz
computation-datum = المرجع
computation-determinant-form = صيغة المحدد
computation-distortion-correction = تصحيح التشوه
computation-free-network = الشبكة الحرة
computation-fundamental-matrix = المصفوفة الأساسية
computation-homography = التحويل الإسقاطي
computation-omega-and-kappa = الزاويتان ω وκ
computation-relative-orientation = التوجيه النسبي
computation-two-view-geometry = هندسة المشهدين

## Why observations do not determine something, or iterations do not converge.

cause-points-on-line = تقع جميع نقاط الصورة { $side } على خط (العرض / الطول = { POWER($width, digits: 1) }؛ المطلوب { POWER($least, digits: 0) } على الأقل)
cause-marks-on-line =
    تقع العلامات { $calibrated ->
        [true] المعايَرة
       *[false] المقيسة
    } على خط (العرض / الطول = { POWER($width, digits: 1) }؛ المطلوب { POWER($least, digits: 0) } على الأقل)
cause-positions-on-line = تقع مواضع GNSS ونقاط الضبط الأرضي على خط (العرض / الطول = { POWER($width, digits: 1) }؛ المطلوب { POWER($least, digits: 0) } على الأقل)
cause-no-extent = ليس للمواضع التقريبية امتداد
cause-one-position = لجميع الصور الموضع نفسه
cause-no-parallax = للصورتين الإحداثيات نفسها، فلا اختلاف منظر
cause-no-base = لا قاعدة (دوران خالص): وسيط اختلاف المنظر بعد الدوران { FIXED($parallax, digits: 1) } من الأخطاء المعيارية لإحداثي الصورة؛ المطلوب أكثر من { $least }
cause-inseparable = لا تكاد المجاهيل تنفصل، كما فوق أسطوانة حرجة أو بلا قاعدة (العدد الشرطي { POWER($condition, digits: 1) }؛ المقبول حتى { POWER($most, digits: 0) })
cause-large-errors = الخطأ المعياري لزاوية أو لاتجاه القاعدة { FIXED($largest_deg, digits: 0) }°
cause-large-residuals = ‏σ0 تبلغ { FIXED($sigma0_px, digits: 1) } بكسل؛ تبلغ المطابقة { FIXED($most_px, digits: 1) } بكسل: المطابقات خاطئة، كما في صور مقلوبة أو غير متداخلة، أو الكاميرا خاطئة
cause-weak-support = لا يتفق إلا { $agreeing } من { $observations } من الأرصاد، وهذا أقل من أن يبيّن الصحيح منها: قِس نقاطًا أكثر، أو اضبط الكل دون حصانة
cause-behind-cameras = لا تقع أمام الكاميرتين إلا { $in_front } من { $points } من النقاط
cause-singular-normals = المعادلات الناظمة شاذة (1 - R² = { POWER($share, digits: 1) }؛ المطلوب أكثر من { POWER($least, digits: 0) })
cause-base-across-x = للقاعدة { POWER($along_x, digits: 1) } من طولها على امتداد x (المطلوب { $least } على الأقل)، فلا قيمة للمركبتين by وbz بوحدة b؛ أدر الصورتين 90°
cause-no-base-along-x = ليس للقاعدة مركبة على امتداد x، وعليها تقسم هذه الصيغة؛ أما الصيغة الدقيقة فتقبل أي قاعدة
cause-gimbal-lock = ‏φ تساوي ±90°، حيث يدور الاثنان حول المحور نفسه
cause-chance = يتفق { $agreeing } من { $matches } من المطابقات على واحدة، وليس هذا أكثر مما تأتي به المصادفة
cause-several-matrices = توافقها أكثر من مصفوفة
cause-too-many-on-line = يقع كثير من النقاط على خط
cause-turned-away = يبتعد عن البداية: تدور الصورة اليمنى أكثر من 60°؛ البداية الحصينة تقبل أي دوران
cause-rising-base = يبتعد عن البداية: ترتفع القاعدة أكثر من 60°؛ البداية الحصينة تقبل أي قاعدة
cause-long-steps = الخطوة الأخيرة أطول { POWER($ratio, digits: 1) } مرة من خطوة تُعد متقاربة
cause-stalled = لا خطوة تخفض المتبقيات أكثر، وطول الأخيرة { POWER($last_step, digits: 1) } من الأخطاء المعيارية
cause-unsettled = ما زال { $unsettled } يتغير بعد { $rounds } من الجولات
cause-point-in-plane = تقع نقطة في مستوى مركز إسقاط
cause-no-rotation = لا شيء يحدد دورانها
cause-no-position = لا شيء يحدد موضعها
cause-few-observations = لها { $observations } من أرصاد النقاط التي تراها صور أخرى؛ المطلوب { $needed } على الأقل
cause-no-camera-parameter = لا شيء يحدد { $camera_parameter } للكاميرا { $camera } (العد من 0)
cause-parts = تنقسم الكتلة إلى { $parts } من الأجزاء التي لا نقاط مشتركة بينها؛ الصورتان { $first } و{ $second } (العد من 0) في جزأين مختلفين
cause-folded-at = ليس لتشوه الكاميرا معكوس عند ({ $x_px }, { $y_px }) بكسل
cause-folded-beyond = ليس لتشوه الكاميرا معكوس على بعد { FIXED($radius_px, digits: 0) } بكسل من النقطة الأساسية

unsettled-gross-errors = رفض الأخطاء الجسيمة
unsettled-positions = رفض مواضع GNSS
unsettled-weights = وزن المواضع المرصودة

side-left = اليسرى
side-right = اليمنى

## Why a pair has no geometry of the two views, or no orientation.

no-geometry-too-few-matches = ليس هناك إلا { $matches } من المطابقات المرشحة المختلفة، والهندسة تحتاج إلى { $needed } على الأقل؛ فلم يُبقَ أي منها
no-geometry-chance = لا يتفق على هندسة واحدة إلا { $agreeing } من { $matches } من المطابقات المرشحة، وليس هذا أكثر مما تأتي به المصادفة؛ فلم يُبقَ أي منها

camera-origin-xmp-calibration = ‏XMP (معايَرة)
camera-origin-xmp-dewarped = ‏XMP (معايَرة، أزيل التشوه من قبل)
camera-origin-xmp-design = ‏XMP (كما صُممت)
camera-origin-exif-focal-plane = EXIF
camera-origin-exif35-mm = ‏EXIF (مكافئ 35 مم)
camera-origin-sensor-table = ‏EXIF والمقاس المسجل لمستشعرها
camera-origin-focal-length-alone = ‏EXIF (البعد البؤري بالمليمتر وحده)
camera-origin-panorama = ‏XMP (بانوراما)

camera-caution-resized = التُقطت بمقاس { $taken_width_px } × { $taken_height_px } بكسل، وفي الملف { $width_px } × { $height_px } بكسل: هل غُيّر حجمها أم قُصّت؟ بعدها البؤري بالبكسل كما لو غُيّر حجمها
camera-caution-cropped = التُقطت بمقاس { $taken_width_px } × { $taken_height_px } بكسل، وهي الآن { $width_px } × { $height_px } بكسل: قُصّت، وبعدها البؤري بالبكسل غير معروف؛ أعط الكاميرا إن عرفتها
camera-caution-focal-plane = يعطي EXIF بكسلات قدرها { SIGNIFICANT($pixel_um, digits: 2) } ميكرومتر، لكنها بهذا المستشعر أو بمكافئه 35 مم { SIGNIFICANT($expected_um, digits: 2) } ميكرومتر: غُيّر حجم الصورة أو قُصّت، وبعدها البؤري بالبكسل غير معروف؛ أعط الكاميرا إن عرفتها
camera-caution-contradiction = يعطي XMP بعدًا بؤريًا قدره { FIXED($xmp_focal_px, digits: 0) } بكسل، وEXIF { FIXED($exif_focal_px, digits: 0) } بكسل: تُستعمل قيمة EXIF
camera-caution-panorama = بانوراما ({ $projection }): ليس لها منظور مركزي ولا كاميرا

no-orientation-too-few-matches =
    { $matches ->
        [0] لم توجد أي مطابقة
        [one] لم توجد إلا مطابقة واحدة
        [two] لم توجد إلا مطابقتان
       *[other] لم توجد إلا { $matches } مطابقات
    }، والتوجيه يحتاج { $needed } على الأقل (هل تُظهر الصورتان الأرض نفسها؟)
no-orientation-no-camera = لم تُعط كاميرا، والصورة { $side } لا تذكر بعدًا بؤريًا
no-orientation-no-focal-length = أُعطيت العلامات الإطارية دون بعد بؤري
no-orientation-no-pixel-size = البعد البؤري للصورة { $side } معروف بالمليمتر لا بالبكسل: لا علامات إطارية ولا حجم بكسل معروفان
no-orientation-altered = عُدّلت الصورة { $side }: { $camera_caution }
no-orientation-contradicted-focal = لا شيء يوافق البعد البؤري المعطى { FIXED($given_px, digits: 0) } بكسل، وملف الصورة { $side } يذكر { FIXED($file_px, digits: 0) } بكسل (هل الكاميرا لصور من قياس آخر أو عدسة أخرى أو تقريب آخر، أم كُتبت القيمة خطأً؟)
no-orientation-far-principal-point = لا شيء يوافق النقطة الرئيسية التي تبعد عن وسط الصورة { $side } بمقدار { SIGNIFICANT($sides, digits: 2) } من ضلعها الأطول، والمعتاد حتى { $most } (هل إحداثياتها بوحدة أخرى أو من مبدأ آخر؟)
no-orientation-panorama = الصورة { $side } بانوراما: ليس لها منظور مركزي ولا كاميرا
no-orientation-no-geometry = لا هندسة للمشهدين: { $no_geometry }
no-orientation-pure-rotation = لا قاعدة يمكن تمييزها (دوران خالص): ضمن دقة المطابقات تختلف الصورتان بدوران وحده، كما حين تكون القاعدة قصيرة قياسًا إلى بُعد ما تظهرانه
no-orientation-plane-without-camera = توافق المطابقات كلها تقريبًا التحويل الإسقاطي لمستوى واحد، كما في أرض مستوية أو دوران خالص، وهو لا يحدد بعدًا بؤريًا: أعط الكاميرا
no-orientation-one-photo = لا قاعدة: تُظهر الصورتان الشيء نفسه في المواضع نفسها (هل هي صورة واحدة مرتين؟)
no-orientation-parts-of-one-image = لا قاعدة: تختلف الصورتان بإزاحة ودوران ومقياس فقط؛ وقد تكونان جزأين من صورة واحدة
no-orientation-refused = { $error }

## What the result of a pair is worth.

pair-verdict-oriented = وُجّه الزوج من { $points } من النقاط، σ0 { $sigma0_px ->
        [none] { SIGNIFICANT($sigma0_um, digits: 2) } ميكرومتر
       *[other] { FIXED($sigma0_px, digits: 2) } بكسل
    }؛ الصورة اليمنى مدارة في مستواها (κ) بمقدار { LIKE($kappa_deg, $half_width_deg, digits: 2) }° ± { SIGNIFICANT($half_width_deg, digits: 2) }°{ $axes_deg ->
        [none] {""}
       *[other] ، وبين محوري الكاميرتين { LIKE($axes_deg, $worst_half_width_deg, digits: 2) }°
    }{ $worst ->
        [omega] ، وتُعرف ω بحدود ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
        [phi] ، وتُعرف φ بحدود ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
        [base] ، ويُعرف اتجاه القاعدة بحدود ± { SIGNIFICANT($worst_half_width_deg, digits: 2) }°
       *[kappa] {""}
    } (‏95 %).
    .label = موجَّه
pair-verdict-weak = توجيه ضعيف من { $points } من النقاط. { $warning }
    .label = ضعيف
pair-verdict-not-oriented = لم يُوجَّه: { $no_orientation }.
    .label = غير موجَّه

## What else would do for a pair.

pair-hint-other-strategy = تقارن هذه الاستراتيجية النوافذ كما هي في الصورتين: حيث تكون مدارة أو مختلفة المقياس أو متداخلة في موضع آخر تجد الاستراتيجية «auto» أكثر.
pair-hint-unknown-camera = توجّه الاستراتيجية «auto» أيضًا صور كاميرا مجهولة، إذ تجدها من المطابقات؛ أما هذه فتحتاج إلى الكاميرا.
pair-hint-turned = الصورة اليمنى مدارة في مستواها بمقدار { FIXED($turn_deg, digits: 0) }°: تقارن هذه الاستراتيجية النوافذ كما هي في الصورتين، وتتحمل حتى ± { $most_deg }°. استعمل الاستراتيجية «auto»، أو أدر الصورة اليمنى إلى وضعها أولًا.
pair-hint-scaled = تُظهر الصورة اليمنى الشيء نفسه أكبر من اليسرى { SIGNIFICANT($scale, digits: 2) } مرة: تقارن هذه الاستراتيجية النوافذ كما هي في الصورتين، وتتحمل حتى { $most } مرة في الاتجاهين. استعمل الاستراتيجية «auto»، أو غيّر قياس إحدى الصورتين أولًا.
pair-hint-turned-and-scaled = الصورة اليمنى مدارة في مستواها بمقدار { FIXED($turn_deg, digits: 0) }° وتُظهر الشيء نفسه أكبر من اليسرى { SIGNIFICANT($scale, digits: 2) } مرة: تقارن هذه الاستراتيجية النوافذ كما هي في الصورتين، وتتحمل حتى ± { $most_deg }° و{ $most } مرة في الاتجاهين. استعمل الاستراتيجية «auto».
pair-hint-displaced = إزاحة الصورة اليمنى { FIXED($dx_px, digits: 0) }، { FIXED($dy_px, digits: 0) } بكسل، وكان المتوقع { FIXED($expected_dx_px, digits: 0) }، { FIXED($expected_dy_px, digits: 0) } بكسل: بُحث عن المطابقات ضمن ± { $most_px } بكسل منه. أعط الإزاحة { FIXED($dx_px, digits: 0) }، { FIXED($dy_px, digits: 0) } بكسل، أو استعمل الاستراتيجية «auto».

## What the geometry of two views is, and where it is degenerate.

two-view-model-calibrated = توجيه كاميرتين معايرتين
    .label = كاميرتان معايرتان
    .estimated = كاميرتان قُدّر بعدهما البؤري من المطابقات
    .short = توجيه نسبي
    .help = توجيه كاميرتين معروفتين، أو تحدد المطابقات بعدهما البؤري: تقع المطابقة على خطها القطبي وأمام الكاميرتين.
two-view-model-fundamental = الهندسة القطبية لكاميرتين مجهولتين
    .label = كاميرتان مجهولتان
    .short = المصفوفة الأساسية
    .help = الهندسة القطبية (المصفوفة الأساسية): تقع المطابقة على خطها القطبي؛ ولا يُعرف شيء عن الكاميرتين.
two-view-model-homography = التحويل الإسقاطي لمستوى
    .label = تحويل إسقاطي لمستوى
    .short = مستوى
    .help = تقع جميع النقاط في مستوى: لكل نقطة في صورة موضع واحد في الأخرى.
two-view-model-rotation = دوران بلا قاعدة
    .label = دوران
    .short = دوران خالص
    .help = لا قاعدة (دوران خالص): لكل نقطة في صورة موضع واحد في الأخرى، أيًا كان بعدها.

degeneracy-plane = تقع جميع النقاط تقريبًا في مستوى: لا يتحدد التوجيه دون كاميرات معروفة؛ ومعها تبيّن التحذيرات إن كان لذلك أثر.
    .short = أرض شبه مستوية
degeneracy-pure-rotation = لا قاعدة يمكن تمييزها (دوران خالص): ضمن دقة المطابقات تختلف الصورتان بدوران وحده، فلا يمكن توجيه شيء.
    .short = لا قاعدة

## Warnings about a relative orientation.

warning-plane = تقع جميع النقاط في مستوى ضمن دقتها: يوافقها توجيه ثان بالجودة نفسها تقريبًا (σ0 له { FIXED($ratio, digits: 2) } مرة؛ يُستبعد ابتداءً من { FIXED($least, digits: 2) }).
warning-clustered = تغطي النقاط جزءًا صغيرًا من الصورة (الجذر التربيعي لمتوسط مربعات بعدها عن وسطها { FIXED($coverage, digits: 2) } من البعد البؤري؛ السليم { $least } على الأقل).
warning-rotation = لا تكاد الصورتان تختلفان إلا بدوران: القاعدة أقصر من أن تتميز عن الضجيج والتشوه (اختلاف المنظر { SIGNIFICANT($parallax_deg, digits: 2) }°؛ السليم { SIGNIFICANT($least_deg, digits: 2) }° على الأقل).
warning-ill-conditioned = لا تكاد المجاهيل تنفصل، كما فوق أسطوانة حرجة (العدد الشرطي { POWER($condition, digits: 1) }؛ السليم حتى { POWER($most, digits: 0) }).
warning-unchecked = لا تكاد الأرصاد، وعددها { $observations }، يتحقق بعضها من بعض: فالخطأ الجسيم في إحداها لا يُكشف إلا إن كان كبيرًا جدًا، ولا يظهر في الأخطاء المعيارية. قِس نقاطًا أكثر.
warning-identical =
    { $copies ->
        [one] رصدة واحدة مطابقة لأخرى
        [two] رصدتان مطابقتان لغيرهما
       *[other] { $copies } من الأرصاد مطابقة لغيرها
    } حتى الرقم الأخير: تُحسب كل منها مرة واحدة.
warning-behind =
    { $points ->
        [one] استُبعدت نقطة واحدة
        [two] استُبعدت نقطتان
       *[other] استُبعدت { $points } من النقاط
    }: تلتقي الأشعة خلف كاميرا، كما في المطابقات الخاطئة والإحداثيات المعكوسة.
warning-sigma = تناقض المتبقيات قيمة σ0 المعطاة: هي { SIGNIFICANT($estimated_um, digits: 3) } ميكرومتر لا { SIGNIFICANT($given_um, digits: 3) } ميكرومتر. تستعمل الأخطاء المعيارية والاختبارات القيمة المقدّرة.
warning-doubtful-base = القاعدة المعطاة { SIGNIFICANT($base_mm, digits: 3) } مم أطول { SIGNIFICANT($times, digits: 2) } مرة من القاعدة بمقياس الصورة، والمعقول حتى { $most } مرة. ويطول by وbz بالقدر نفسه: هل هي القاعدة على الأرض أو بوحدة أخرى؟
warning-few-places = تقع المطابقات في { $places ->
        [one] موضع واحد
        [two] موضعين
       *[other] { $places } من المواضع
    } من الصورة؛ السليم { $least } على الأقل.
warning-few-matches = لم يشارك إلا { $matches } من المطابقات؛ وقد يتفق مثل هذا العدد القليل على نمط متكرر. ويلزم { $least } على الأقل لاستبعاد ذلك.
warning-few-agree = لا يتفق مع التوجيه إلا { $accepted } من { $matches } من المطابقات.
warning-mirrored = تُظهر الصورة اليمنى الأرض معكوسة كما في المرآة.
warning-mirrored-marks = تقع العلامات الإطارية معكوسة في الصورة { $side }: هل المسح الضوئي معكوس، أم إحداثياتها؟
warning-unknown-camera = لا يكاد البعد البؤري يُعرف، ولا تحدده المطابقات، وقد لا تصح المجالات: أعط الكاميرا.
warning-contradicted-focal = البعد البؤري المعطى { FIXED($given_px, digits: 0) } بكسل، لكن ملف الصورة { $side } يذكر { FIXED($file_px, digits: 0) } بكسل: هل الكاميرا لصور من قياس آخر أو عدسة أخرى أو تقريب آخر؟
warning-doubtful-focal = البعد البؤري للصورة { $side } يساوي { SIGNIFICANT($sides, digits: 2) } من الضلع الأطول للصورة، والمعتاد من { $least } إلى { $most }: تحقق من البعد البؤري ومن قياس البكسل.
warning-far-principal-point = تبعد النقطة الرئيسية للصورة { $side } عن وسط الصورة { SIGNIFICANT($sides, digits: 2) } من ضلعها الأطول، والمعتاد حتى { $most }: تحقق من إحداثياتها ومن وحدتها.
warning-doubtful-distortion = تنقل تشوهات الصورة { $side } زاويةً من صورتها إلى { SIGNIFICANT($factor, digits: 2) } من بعدها عن النقطة الرئيسية، والمعتاد من { $least } إلى { $most }: تحقق من الحدود، ووحداتها مم⁻² ومم⁻⁴ ومم⁻⁶.
warning-resized-or-cropped = في ملف الصورة { $side } بكسلات أقل مما تذكره بيانات EXIF فيه ({ $width_px } × { $height_px } لا { $taken_width_px } × { $taken_height_px }): هل غُيّر حجمها أم قُصّت؟ لا تكاد كاميرتها تُعرف، وقد لا تصح المجالات: أعط الكاميرا.
warning-cropped = قُصّت الصورة { $side }: في ملفها { $width_px } × { $height_px } بكسل، وتذكر بيانات EXIF فيه { $taken_width_px } × { $taken_height_px }. لا تكاد كاميرتها تُعرف، وقد لا تصح المجالات: أعط الكاميرا.
warning-unused-pixel = لا يُستعمل حجم بكسل الكاميرا { SIGNIFICANT($pixel_mm, digits: 3) } مم: فبكسل المسح الضوئي بحسب العلامات الإطارية { SIGNIFICANT($marks_mm, digits: 3) } مم.
warning-other-pixels = غُيّر حجم الصورة { $side } أو قُصّت: تعطي بيانات EXIF فيها بكسلات قدرها { SIGNIFICANT($pixel_um, digits: 2) } ميكرومتر، ويعطي مستشعرها أو مكافئه 35 مم { SIGNIFICANT($expected_um, digits: 2) } ميكرومتر. لا تكاد كاميرتها تُعرف، وقد لا تصح المجالات: أعط الكاميرا.
warning-similarity-alone = لا تكاد الصورتان تختلفان بأكثر من إزاحة ودوران ومقياس، كما في أجزاء من صورة واحدة، وكما قد يكون في صور مستوية فوق أرض مسطحة: فإن كانتا جزأين من صورة واحدة فالتوجيه خاطئ.
warning-exact = ‏σ0 تبلغ { SIGNIFICANT($sigma0_px, digits: 1) } بكسل، كما في أجزاء من صورة واحدة؛ ولا تتفق صورتان بأدق من { $least_px } بكسل.
warning-wide-angle = تبتعد النقاط عن المحور كثيرًا بالنسبة إلى بعدها البؤري (الجذر التربيعي لمتوسط مربعات بعدها عن وسطها { FIXED($coverage, digits: 2) } من البعد البؤري؛ المعتاد حتى { $most }): هل البعد البؤري أقصر من الصحيح؟
warning-uncertain = يُعرف الدوران بحدود ±{ SIGNIFICANT($half_width_deg, digits: 2) }° فقط (95 %)؛ السليم حتى ±{ $most_deg }°.
warning-uncertain-base = يُعرف اتجاه القاعدة بحدود ±{ SIGNIFICANT($half_width_deg, digits: 2) }° فقط (95 %)؛ السليم حتى ±{ $most_deg }°.
warning-imprecise = ‏σ0 تبلغ { FIXED($sigma0_px, digits: 1) } بكسل؛ تبلغ المطابقة { FIXED($most_px, digits: 1) } بكسل حيث تكون الكاميرا وتشوهها صحيحين. وقد لا تصح المجالات.
warning-coarse = ‏σ0 تبلغ { SIGNIFICANT($sigma0_um, digits: 2) } ميكرومتر، والقياس يبلغ { SIGNIFICANT($most_um, digits: 2) } ميكرومتر عند هذا البعد البؤري: في كثير من الأرصاد أخطاء جسيمة لا يبين أي اختبار أيها، أو أن البعد البؤري بوحدة أخرى.
warning-focal-length = تطلب المتبقيات بعدًا بؤريًا يختلف بنسبة { FIXED($change_percent, digits: 2) } % ({ FIXED($w, digits: 1) } من الأخطاء المعيارية)، وهو ما يخرج النتيجة من مجالات الثقة 95 %.
warning-unchecked-focal = يوافق نصفُ البعد البؤري بالجودة نفسها تقريبًا (σ0 له { FIXED($ratio, digits: 2) } مرة؛ يُستبعد ابتداءً من { FIXED($least, digits: 2) }): فمجال الرؤية ضيق والأرض شبه مستوية، فلا تتحقق الصورتان من البعد البؤري المعطى.

## Pairs of a block: what came of matching them, and why they were chosen.

connection = { $outcome }؛ { $rule }

outcome-waiting = لم يُطابَق بعد
outcome-connected = متصل بعدد { $matches } من المطابقات
outcome-too-few-matches = غير متصل: { $matches } من المطابقات؛ المطلوب { $needed } على الأقل
outcome-not-oriented = غير متصل: { $no_geometry }
outcome-failed = غير متصل: { $failure }

rule-all = تُجرَّب جميع الأزواج
rule-near = اختير لتقارب الصورتين
rule-sequence = اختير لتتابع الصورتين
rule-alike = اختير لتشابه الصورتين

## Why a file was skipped, or a job of a run failed.

failure-unreadable = { $message }
failure-refused =
    { $error ->
        [none] { $message }
       *[other] { $error }
    }
failure-broke-off = انقطع الحساب بعطل في البرنامج ({ $message }): نرجو الإبلاغ عنه
failure-out-of-memory = نفدت الذاكرة ({ $message })

## Why an image is not oriented. They follow the name of the image and a colon.

unoriented-no-points = ليس لها نقاط ربط
unoriented-too-few-points =
    { $points ->
        [one] تقاطعت من نقاط ربطها نقطة واحدة
        [two] تقاطعت من نقاط ربطها نقطتان
       *[other] تقاطعت { $points } من نقاط ربطها
    } بصور موجَّهة؛ المطلوب { $needed } على الأقل
unoriented-no-agreement = يتفق { $agreeing } من { $points } من أرصادها لنقاط متقاطعة على توجيه واحد؛ المطلوب { $needed } على الأقل وخُمسها
unoriented-narrow = تقع { $agreeing } من أرصادها المتفقة على خط أو في بقعة واحدة من الصورة
unoriented-no-partner = نقاط ربطها المشتركة مع كل صورة أخرى قليلة، أو لا قاعدة بينها وبين أي صورة
unoriented-lost =
    وُجّهت، لكن لم يبق لها إلا { $rays ->
        [one] رصدة واحدة
        [two] رصدتان
        [few] { $rays } أرصاد
        [many] { $rays } رصدة
       *[other] { $rays } رصدة من أرصادها
    }
unoriented-undetermined =
    وُجّهت بـ{ $rays ->
        [one] رصدة واحدة
        [two] رصدتين
        [few] { $rays } أرصاد
       *[other] { $rays } رصدة
    }؛ وقد رفض ضبط الحزم كثيرًا منها
unoriented-rejected-by-hand = رُفضت يدويًا

image-reason-apart = في نموذج مستقل من { $images } من الصور
image-reason-unoriented = { $unoriented }
image-reason-failed = { $failure }
image-reason-unknown = غير موجَّهة

## What a block is worth.

block-verdict-oriented =
    وُجّهت { $oriented } من { $images } من الصور من { $points } من النقاط{ $sigma0_px ->
        [none] .
       *[other] ، σ0 { FIXED($sigma0_px, digits: 2) } بكسل.
    }
    .label = موجَّهة
block-verdict-weak = توجيه ضعيف: { $oriented } من { $images } من الصور من { $points } من النقاط. { $overview_warning }
    .label = ضعيفة
block-verdict-not-oriented =
    لم تُوجَّه: { $connected ->
        [0] لم يمكن وصل أي صورتين
       *[other] { $failure ->
            [none] لم يمكن توجيه أي صورة
           *[other] { $failure }
        }
    }.
    .label = غير موجَّهة

## Warnings about a block at a glance.

overview-warning-model = { $block_warning }
overview-warning-few-oriented = تعذّر توجيه أكثر من خُمس الصور.
overview-warning-apart = وُجّهت { $images } من الصور بمعزل عن غيرها، في نموذج مستقل.
overview-warning-not-on-orthophoto = ليست الكتلة في نظام الصورة المصححة، وهي كما كانت دونها: { $not_linked }.
overview-warning-focal-apart = البعد البؤري للكاميرا { $label } مع الصورة المصححة { FIXED($estimated_px, digits: 1) } بكسل، والمعروف { FIXED($prior_px, digits: 1) } بكسل، والفرق { FIXED($apart, digits: 1) } انحرافًا معياريًا منه: تحقق من الكاميرا والارتفاعات ووحدتها.
overview-warning-few-matches = لا تربط الصورتين إلا { $matches } من المطابقات؛ وقد يتفق مثل هذا العدد القليل على نمط متكرر. ويلزم { $least } على الأقل لاستبعاد ذلك.
overview-warning-no-points = لم تبقَ نقطة ربط: لا شيء مما يشارك يبيّن موضع الصور.
overview-warning-none-oriented = لم يمكن توجيه أي صورة.
overview-warning-doubtful-camera = لا تكاد إحدى الكاميرات تكون الصحيحة ({ $remark }).
overview-warning-failed = لم يمكن توجيه أي صورة: { $failure }.

## Warnings about an adjusted block.

block-warning-free =
    { $without_heights ->
        [0] لا مواضع مرصودة تحدد موضع النموذج ودورانه ومقياسه
       *[other] لا تحدد مواضع GNSS، وعددها { $without_heights }، موضع النموذج ودورانه ومقياسه، إذ لا تُعرف ارتفاعاتها فوق صفر نقاط الضبط (--geoid، --geoid-m)، ولا تحددها نقاط ضبط موافقة
    }: هي اعتباطية{ $cause ->
        [none] .
       *[other] {" "}({ $cause }).
    }
block-warning-unknown-rotation =
    لا تحدد { $observed } دوران الكتلة كلها حول خطها{ $tilt_deg ->
        [none] .
       *[other] ؛ تميل المشاهد { FIXED($tilt_deg, digits: 0) }° عن الشاقول في المتوسط.
    }
block-warning-uncertain-rotation =
    لا تكاد { $observed } تحدد دوران الكتلة كلها: زواياها غير مؤكدة بمقدار ± { FIXED($error_deg, digits: 0) }° أو أكثر{ $tilt_deg ->
        [none] .
       *[other] ؛ تميل المشاهد { FIXED($tilt_deg, digits: 0) }° عن الشاقول في المتوسط.
    }
block-warning-looking-up = تنظر معظم المشاهد إلى أعلى، بزاوية { FIXED($tilt_deg, digits: 0) }° عن الشاقول. ما لم تُظهر سقفًا فإن محورين من { $observed } متبادلان، كأن يسبق الشمالُ الشرقَ في الملف، أو أن الارتفاعات تتجه إلى أسفل.
block-warning-levelled =
    مواضع GNSS { $error_deg ->
        [none] لا تحدد دوران الكتلة كلها
       *[other] لا تكاد تحدد دوران الكتلة كلها (± { FIXED($error_deg, digits: 0) }°)
    }: { $recorded ->
        [true] تسوّيها اتجاهات النظر المسجلة
       *[false] تُعد مشاهدها شاقولية في المتوسط
    }، بافتراض ± { FIXED($level_deg, digits: 0) }°.
block-warning-imprecise =
    ‏σ0 تبلغ { FIXED($sigma0_px, digits: 1) } بكسل، فوق { FIXED($most_px, digits: 0) } بكسل التي تبلغها المطابقة بالكاميرا الصحيحة: تشوه، أو كاميرا خاطئة، أو مطابقات خاطئة.
block-warning-weights-not-converged = ما زالت الأوزان بحسب المتبقيات تتغير بعد { $rounds } من جولات الوزن: الأخطاء المعيارية المذكورة لا يوافق بعضها بعضًا.
block-warning-no-heights = لا تشارك ارتفاعات مواضع GNSS: يُعد الطيران أفقيًا، وتُحسب الارتفاعات منه، وقد تكون الكتلة مائلة.
block-warning-positions-rejected =
    { $images_count ->
        [one] موضع GNSS واحد لا يوافق ورُفض، ومعه بعده
        [two] موضعا GNSS لا يوافقان ورُفضا، ومعهما بعداهما
       *[other] { $images_count } من مواضع GNSS لا توافق ورُفضت، ومعها أبعادها
    }: { $images }{ $images_more ->
        [0] .
       *[other] {" "}و{ $images_more } أخرى.
    }
    .images = { $name } ({ FIXED($distance_m, digits: 1) } م)
block-warning-positions-apart =
    تختلف مواضع GNSS كلها على السواء عما تقوله { $held_by ->
        [places] مواضع الصورة المصححة
        [both] نقاط الضبط ومواضع الصورة المصححة
       *[surveyed] نقاط الضبط
    } في { $axis } بمقدار { FIXED($difference_m, digits: 2) } م، أي { FIXED($times, digits: 1) } أمثال الخطأ المعياري لهذا الفرق: { $axis ->
        [z] { $held_by ->
            [places] ربما تُحسب ارتفاعاتها وارتفاعات الصورة المصححة من صفرين مختلفين، كالمجسم الإهليلجي ومستوى سطح البحر (--geoid-m)، أو هذه منزاحة كلها، أو
            [both] ربما تُحسب ارتفاعاتها وارتفاعات نقاط الضبط والصورة المصححة من أصفار مختلفة، كالمجسم الإهليلجي ومستوى سطح البحر (--geoid-m)، أو بعضها منزاح كله، أو
           *[surveyed] ربما تُحسب ارتفاعاتها وارتفاعات نقاط الضبط من صفرين مختلفين، كالمجسم الإهليلجي ومستوى سطح البحر (--geoid-m)، أو
        }
       *[other] ربما كانت هي { $held_by ->
            [places] والصورة المصححة في نظامين مختلفين
            [both] ونقاط الضبط والصورة المصححة في أنظمة مختلفة
           *[surveyed] ونقاط الضبط في نظامين مختلفين
        }، أو
    } للمواضع إزاحة مشتركة (--gnss-errors offset).{ $images_m ->
        [none] {""}
       *[other] {" "}وقد تبعتها الصور بمقدار { FIXED($images_m, digits: 2) } م، وهو ما لا تغطيه أخطاؤها المعيارية.
    }{ $focal ->
        [true] {" "}وتخطئ بجزء منها الأبعاد البؤرية المقدرة ومعها ارتفاعات الصور.
       *[false] {""}
    }{ $control ->
        [true] {" "}وقد تكون نقاط الضبط التي لا تتوافق صحيحة.
       *[false] {""}
    }
block-warning-positions-elsewhere =
    تبعد مواضع GNSS في الجدول { SIGNIFICANT($distance_km, digits: 3) } كم عما { $images ->
        [one] يسجله ملف صورة واحدة
       *[other] تسجله ملفات الصور في الوسيط، وعددها { $images }
    }. { $place_slip ->
        [none] { $in_crs ->
            [true] هل هي مواضع هذه الصور وفي النظام المذكور، أم أن مواضع الملفات خاطئة؟
           *[false] هل هي مواضع هذه الصور، أم أن مواضع الملفات خاطئة؟
        }
       *[other] { $place_slip }
    }
block-warning-position-errors-undetermined =
    { $errors ->
        [one] خطأ منتظم واحد لمواضع GNSS غير محدد فعُدّ صفرًا
        [two] خطآن منتظمان لمواضع GNSS غير محددين فعُدّا صفرًا
       *[other] { $errors } من الأخطاء المنتظمة لمواضع GNSS غير محددة فعُدّت صفرًا
    }: تحدد نقاط الضبط الأرضي الإزاحات، وتحدد الصور الملتقطة في عدة اتجاهات طيران أذرع الهوائي.
block-warning-position-errors-relative = إزاحات مواضع GNSS وانجرافاتها نسبية بعضها إلى بعض: نقاط الضبط الأرضي أقل من أن تحدد { $motions } من المعاملات السبعة التي تضع الكتلة كلها وتدورها وتقيسها.
block-warning-control-refused =
    { $used ->
        [true] لا يوافق { $axis } لنقطة الضبط الأرضي { $point } سائر الأرصاد
       *[false] رُفض { $axis } لنقطة الضبط الأرضي { $point }
    }: تختلف عنه الأرصاد الأخرى بمقدار { FIXED($difference_m, digits: 3) } م ± { FIXED($error_m, digits: 3) } م{ $detectable_m ->
        [none] {""}
       *[other] {" "}(أصغر انحياز يمكن كشفه { FIXED($detectable_m, digits: 3) } م)
    }. { $used ->
        [true] تبقى النقطة مستعملة، لأن ما يبقى دونها أقل من أن يبيّن هل هي خاطئة.
       *[false] { $certain ->
            [true] لا تشارك النقطة.
           *[false] لا تشارك النقطة، لأن قياساتها الصورية لا توافق إحداثياتها. وما يبقى دونها أقل من أن يبيّن هل هي الخاطئة أم نقطة ضبط أخرى.
        }
    }{ $mistake ->
        [none] {""}
       *[other] {" "}{ $mistake }
    }
block-warning-control-untested =
    لا تشارك نقطة الضبط الأرضي { $point }: { $measurements ->
        [one] ليس لها إلا قياس صوري واحد
        [two] لا يوافق الأرصادَ الأخرى أكثر من واحد من قياسيها الصوريين
       *[other] لا يوافق الأرصادَ الأخرى أكثر من واحد من قياساتها الصورية، وعددها { $measurements }
    }، فلا شيء يختبر إحداثياتها. تحقق من كليهما.
block-warning-control-unplaced =
    رُفضت نقطة الضبط الأرضي { $point } ولا تشارك: معها لا تضع نقاط الضبط الأرضي الكتلة، مع أن إحداثياتها توافق الأرصاد الأخرى. تحقق من { $measurements ->
        [one] قياسها الصوري
        [two] قياسيها الصوريين
       *[other] قياساتها الصورية، وعددها { $measurements }
    }.
block-warning-control-contradicts =
    تتناقض { $refused } من { $points } من نقاط الضبط الأرضي فيما بينها أو مع الأرصاد الأخرى{ $w ->
        [none] {""}
       *[other] {" "}حتى w = { FIXED($w, digits: 1) }
    }، ولا شيء يبيّن أيها خاطئ: تبقى مستعملة. تحقق من إحداثياتها وأخطائها المعيارية ومن نظامها ووحداتها ومن مواضع GNSS.
block-warning-control-tests-stopped =
    توقفت اختبارات نقاط الضبط الأرضي: كان عليها أن تستبعد { $left_out } من { $points }، ودون { $left_out ->
        [one] هذه النقطة
        [two] هاتين النقطتين
       *[other] هذه النقاط
    } لا يمكن تعديل الكتلة. تبقى نقاط الضبط كلها مستعملة، ومنها الخاطئة. تحقق من إحداثياتها وقياساتها الصورية.
block-warning-control-unadjusted =
    لا يمكن تعديل الكتلة مع { $names_count ->
        [one] نقطة الضبط الأرضي { $names }
       *[other] نقاط الضبط الأرضي { $names }{ $names_more ->
            [0] {""}
           *[other] {" "}و{ $names_more } أخرى
        }
    } لبُعدها عن موضعها وفق سائر النقاط: لا تدخل في التعديل، وعُدّلت الكتلة دون إسناد جغرافي. تحقق من الإحداثيات والقياسات الصورية.
block-warning-control-lost =
    لا تشارك { $lost } من نقاط الضبط الأرضي المقيسة، وعددها { $points }، أو تشارك بقياس صوري واحد، إذ لا تتوافق قياساتها الصورية{ $control_apart ->
        [none] {""}
       *[other] {" "}وإحداثياتها
    }: { $from_bottom ->
        [true] تلتقي لو عُدّت الصفوف من أسفل الصور. هنا y صفر في الأعلى: استعمل ارتفاع الصورة ناقص y.
       *[other] { $control_apart ->
            [none] تحقق من الصور والنقاط التي تسميها، ومن أنها ببكسلات هذه الصور، وأن x إلى اليمين وy من الأعلى إلى الأسفل.
           *[other] { $control_apart }
        }
    }
block-warning-check-refused =
    يختلف { $axis } لنقطة التحقق { $point } عن الكتلة بمقدار { FIXED($difference_m, digits: 3) } م ± { FIXED($error_m, digits: 3) } م (المضبوط ناقص المقيس): إحداثياتها أو قياساتها الصورية خاطئة، أو تخطئ الكتلة في موضعها.{ $mistake ->
        [none] {""}
       *[other] {" "}{ $mistake }
    }
block-warning-checks-apart =
    { $points ->
        [one] تختلف نقطة التحقق
       *[other] تختلف نقاط التحقق كلها، وعددها { $points }،
    } عن الكتلة في { $axis } بمقدار { FIXED($difference_m, digits: 2) } ± { FIXED($error_m, digits: 2) } م (المضبوط ناقص المقيس): { $axis ->
        [z] هل تُحسب ارتفاعاتها من صفر آخر، كالمجسم الإهليلجي أو مستوى سطح البحر، أو من موضع آخر من العلامات؟
       *[other] هل هي في نظام إحداثيات مرجعي آخر؟
    }
block-warning-stated-errors =
    { $columns_count ->
        [one] يذكر العمود
       *[other] تذكر الأعمدة
    } { $columns } من جدول { $observed } أخطاء معيارية وسيطها { SIGNIFICANT($stated, digits: 2) }، وتُحسب أمتارًا{ $residual_m ->
        [none] {""}
       *[other] ، مع أن البواقي بواقي أخطاء معيارية قدرها { SIGNIFICANT($residual_m, digits: 2) } م
    }: فلا يكاد يكون لها وزن. إن كانت الأعداد بوحدة { $unit } فاكتب ذلك بعد { $columns_count ->
        [one] اسم العمود
       *[other] أسماء الأعمدة
    }: { $unit ->
        [millimetres] (mm)
       *[other] (cm)
    }.
block-warning-control-elsewhere =
    لا يقع أي قياس صوري { $check ->
        [true] لنقاط التحقق
       *[false] لنقاط الضبط الأرضي
    }، وعددها { $points }، في صورة من الكتلة. { $images_count ->
        [0] لا يسمي جدول القياسات أيًا من النقاط.
       *[other] يسمي جدول القياسات { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}و{ $images_more } أخرى
        }: سمِّ الصور فيه بأسماء ملفاتها.
    }
block-warning-control-without-place = لا تضع نقاط الضبط الأرضي، وعددها { $given }، الكتلة: قيس منها في صورتين من صورها أو أكثر { $measured }، وتلتقي قياسات { $taken }. المطلوب ثلاث، أو مواضع GNSS معها.
block-warning-control-shape =
    نقاط الضبط الأرضي { $names }{ $names_more ->
        [0] {""}
       *[other] {" "}و{ $names_more } أخرى
    } لا يوافق بعضها بعضًا، فلا تضع الكتلة: وفق إحداثياتها تكون الكتلة بين { $longest } أكبر { SIGNIFICANT($ratio, digits: 3) } مرة منها بين { $shortest }. { $point ->
        [none] ولا شيء يبيّن أيها الخاطئة: تحقق من إحداثياتها كلها.
       *[other] ودون { $point } تتوافق الأخرى: تحقق من إحداثياتها أولًا.
    }
block-warning-few-control =
    { $points ->
        [one] نقطة ضبط أرضي واحدة فقط
        [two] نقطتا ضبط أرضي فقط
       *[other] { $points } من نقاط الضبط الأرضي فقط
    } { $positions ->
        [0] دون مواضع GNSS
        [one] مع موضع GNSS واحد
        [two] مع موضعي GNSS
       *[other] مع { $positions } من مواضع GNSS
    } تضع الكتلة: { $detectable_m ->
        [none] لا شيء يتحقق من بعض الإحداثيات، ولا يظهر خطأ فيها.
       *[other] لا تكاد تتحقق إحداها من الأخرى، وأصغر انحياز يمكن كشفه في إحداثي هو { FIXED($detectable_m, digits: 2) } م.
    }
block-warning-control-span = تغطي نقاط الضبط الأرضي، وعددها { $points }، { FIXED($span_percent, digits: 1) } % من أرض الكتلة: تكبر الأخطاء خارجها مع المسافة.
block-warning-control-on-line =
    تقع نقاط الضبط الأرضي، وعددها { $points }، على خط تقريبًا، عرضها { FIXED($width_percent, digits: 1) } % من طولها: لا تكاد تحدد الدوران حوله{ $error_deg ->
        [none] .
       *[other] ، وزوايا جميع الصور غير مؤكدة بمقدار ± { SIGNIFICANT($error_deg, digits: 2) }° أو أكثر.
    }
block-warning-scale =
    تجعل نقاط الضبط الأرضي الكتلة أكبر { SIGNIFICANT($ratio, digits: 2) } مرة مما تجعلها مواضع GNSS: { $unit ->
        [none] المطلوب أمتار.
       *[other] هل هي بوحدة { $unit }؟
    }
block-warning-degrees = تبدو x وy لنقاط الضبط الأرضي خط طول وعرض: سمِّ نظامها الإحداثي (--crs EPSG:4326)، أو أعطِ إحداثيات بالأمتار.
block-warning-point-rejected =
    { $check ->
        [true] لم تُحدَّد نقطة التحقق { $point }
       *[false] لا تشارك نقطة الضبط { $point }
    }: { $measurements ->
        [one] قيست في صورة موجَّهة واحدة.
        [two] قياساها الصوريان في صور موجَّهة لا يلتقيان.
       *[other] قياساتها الصورية في صور موجَّهة، وعددها { $measurements }، لا تلتقي.
    }
block-warning-measurements-rejected =
    { $images_count } من { $measurements ->
        [one] قياس صوري واحد
        [two] قياسين صوريين
       *[other] { $measurements } من القياسات الصورية
    } { $check ->
        [true] لنقطة التحقق
       *[false] لنقطة الضبط
    } { $point } { $images_count ->
        [one] لا يوافق
       *[other] لا توافق
    }: { $images }{ $images_more ->
        [0] .
       *[other] {" "}و{ $images_more } أخرى.
    }
block-warning-focal-estimated = البعد البؤري لـ{ $camera } غير معروف؛ قُدّر بخطأ معياري ± { FIXED($error_px, digits: 1) } بكسل.
block-warning-focal-undetermined = البعد البؤري لـ{ $camera } غير معروف، ولا تحدده الكتلة: مقياس الارتفاعات خاطئ.
block-warning-focal-of-ground = تجعل الصور وحدها البعد البؤري لـ{ $camera } { FIXED($images_px, digits: 1) } ± { FIXED($images_error_px, digits: 1) } بكسل، وتجعله مواضع الصورة المصححة { FIXED($ground_px, digits: 1) } ± { FIXED($ground_error_px, digits: 1) } بكسل، والفرق أكبر مما تفسره الصدفة: قد تكون ارتفاعات الصور خاطئة بهذا القدر. أعطِ كاميرا معايرة، أو افحص الصورة المصححة وارتفاعاتها.
block-warning-orthophoto-apart =
    تضع الصورة المصححة الكتلة أفقيًا على بُعد { AMOUNT($plan_m, digits: 0) } م من مواقع صورها في GNSS، في وسيط { $images } منها، والمعتاد { AMOUNT($usual_m, digits: 0) } م على الأكثر: تحقق من النظام الإحداثي للصورة المصححة ومن المواقع.
block-warning-orthophoto-heights-apart =
    تضع الصورة المصححة الكتلة { SIGN($height_m) ->
        [minus] أدنى
       *[plus] أعلى
    } من مواقع صورها في GNSS بمقدار { AMOUNT($height_m, digits: 1) } م، في وسيط { $images } منها، والمعتاد { FIXED($usual_m, digits: 1) } م على الأكثر: تحقق من الارتفاعات، فهي منزاحة كلها أو محسوبة من صفر غير صفر المواقع، كمستوى سطح البحر بدل المجسم الإهليلجي (--heights-geoid-m)، ومن المواقع.
block-warning-orthophoto-heights-scatter = تتفرق ارتفاعات أرض الصورة المصححة ± { FIXED($scatter_m, digits: 1) } م حول ما تجعله الكتلة، بحسب { $checks } من المواضع التي تتحقق منها، والمذكور ± { FIXED($stated_m, digits: 1) } م: بعضها منزاح، كأن يكون ذلك في جزء من الأرض، أو كلها أقل دقة (--height-sigma-m)، وقد تكون ارتفاعات الصور خاطئة بالقدر نفسه.
block-warning-parameter-fixed = لا تحدد الكتلة { $camera_parameter } لـ{ $camera }؛ فبقيت قيمته التقريبية.
block-warning-few-observations =
    { $images_count ->
        [one] لصورة واحدة
        [two] لصورتين
       *[other] لـ{ $images_count } من الصور
    } أقل من { $least } من الأرصاد: { $images }{ $images_more ->
        [0] .
       *[other] {" "}و{ $images_more } أخرى.
    }
block-warning-two-rays = لـ{ $two } من { $points } من نقاط الضبط شعاعان فقط: لا تظهر أخطاؤها على امتداد القاعدة.
block-warning-many-rejected = { $rejected } من { $observations } من الأرصاد أخطاء جسيمة.

observed-positions = مواضع GNSS
observed-points = نقاط الضبط الأرضي
observed-both = مواضع GNSS ونقاط الضبط الأرضي

axis-x = x
axis-y = y
axis-z = z

mistake-exchanged = يبدو أن x وy لها مبدَّلان.
mistake-sign = تبدو إشارة { $axis } لها خاطئة: { $given }.
mistake-decimal-point = تبدو الفاصلة العشرية في { $axis } لها في غير موضعها: { $given } والموافق { $likely }.
mistake-feet = يبدو ارتفاعها بالقدم: { $given } قدم تساوي { $likely } م.
mistake-metres = يبدو ارتفاعها بالمتر: { $given } م تساوي { $likely } قدم.
mistake-digit = يبدو أن رقمًا في { $axis } لها كُتب خطأ: { $given } والموافق { $likely }.
mistake-transposed = يبدو أن رقمين في { $axis } لها مبدَّلان: { $given } والموافق { $likely }.
mistake-zone = تبدو إحداثياتها من المنطقة { $zone }.
mistake-name = توافق قياساتها في الصور إحداثيات { $other }: يبدو أن اسميهما مبدَّلان.

unit-millimetres = المليمتر
unit-centimetres = السنتيمتر
unit-inches = البوصة
unit-feet = القدم
unit-kilometres = الكيلومتر

# `first`: the name of its first image; `more`: how many it has beside that.
camera =
    { $only ->
        [true] الكاميرا
       *[false] الكاميرا { $number }{ $first ->
            [none] {""}
           *[other] {" "}({ $first }{ $more ->
                [0] {""}
                [one] {" "}وصورة أخرى
                [two] {" "}وصورتان أخريان
               *[other] {" "}و{ $more } من الصور الأخرى
            })
        }
    }

camera-parameter-focal = البعد البؤري
camera-parameter-principal-x = عمود النقطة الأساسية
camera-parameter-principal-y = صف النقطة الأساسية
camera-parameter-k1 = k1
camera-parameter-k2 = k2
camera-parameter-k3 = k3
camera-parameter-p1 = p1
camera-parameter-p2 = p2

## Remarks on what a run was given.

remark-older-project = ملف المشروع من الإصدار { $version }: لا يحوي السمات ولا الكاميرات كما أُعطيت ولا الأخطاء المعيارية
remark-result-system =
    الملفات images.csv وpoints.csv وsurveyed.csv في { $crs }{ $accuracy_m ->
        [none] {""}
       *[other] . والانتقال من WGS 84 هو { $operation }، بدقة { SIGNIFICANT($accuracy_m, digits: 1) } م
    }{ $gnss_above_m ->
        [none] {""}
       *[other] . وارتفاعاته من سطح خاص به: لم تشارك ارتفاعات مواضع GNSS. وهي { SIGN($gnss_above_m) ->
            [minus] أدنى
           *[plus] أعلى
        } من ارتفاعات الكتلة بنحو { AMOUNT($gnss_above_m, digits: 0) } م: وهو ارتفاع الجيوئيد تقريبًا (--geoid، --geoid-m) إذا كانت فوق الإهليلجي
    }
remark-ellipsoidal-heights = الارتفاعات في images.csv وpoints.csv وsurveyed.csv فوق الإهليلجي، كارتفاعات مواضع GNSS، وليست ارتفاعات { $crs }: لم يُعطَ الجيوئيد (--geoid، --geoid-m)
remark-gnss-without-system = لا تشارك مواضع GNSS، وعدد صورها { $positions }: لم يُسمَّ نظام الإحداثيات المرجعي لنقاط الضبط؛ سمِّه (--crs)
remark-geoid = تُحسب الارتفاعات من جيوئيد { $name }، الذي يعلو المجسم الإهليلجي بمقدار { FIXED($low_m, digits: 2) } إلى { FIXED($high_m, digits: 2) } م حيث الصور
remark-no-result-system = النتائج ليست في { $crs }: ليس للكتلة موضع على الأرض، وتعطيه نقاط ضبط موافقة، أو مواضع GNSS تُحسب ارتفاعاتها من الصفر نفسه
remark-orthophoto-system-assumed = لا تذكر الصورة المصححة نظامها المرجعي للإحداثيات: أُخذت على أنها في { $crs }
remark-orthophoto-converted =
    حُولت مواضع الصورة المصححة من { $orthophoto } إلى { $crs }{ $accuracy_m ->
        [none] {""}
       *[other] ، بدقة { SIGNIFICANT($accuracy_m, digits: 1) } م لانتقالي مرجعيهما
    }
remark-orthophoto-elsewhere =
    { $images ->
        [1] موقع الصورة في GNSS لا يقع
       *[other] لا موقع في GNSS من مواقع { $images } من الصور يقع
    } ضمن { FIXED($within_m, digits: 0) } م من الصورة المصححة: أقربها كما يضعه { $crs } يبعد عنها { SIGNIFICANT($distance_km, digits: 3) } كم. { $place_slip } ويُبحث فيها كلها
remark-orthophoto-heights =
    ارتفاعات أرض الصورة المصححة تُعدّ من { $from_ellipsoid ->
        [true] الإهليلج
       *[false] جيوئيد أو مستوى بحر
    } كما يقول ملفها ({ $heights })، وارتفاعات { $crs } من { $from_ellipsoid ->
        [true] جيوئيد
       *[false] الإهليلج
    }: موقع الكتلة { $above_m ->
        [none] مزاح في الارتفاع بمقدار ارتفاع الجيوئيد
       *[other] { SIGN($above_m) ->
            [minus] أدنى
           *[plus] أعلى
        } مما يجب بمقدار { AMOUNT($above_m, digits: 1) } م
    }؛ حوّل الارتفاعات، أو بيّن بالخيار --geoid أو --geoid-m أو --crs أن صفرهما واحد
remark-mosaic-heights =
    ارتفاعات أرض الموزاييك تُعدّ من { $from_ellipsoid ->
        [true] الإهليلج
       *[false] جيوئيد أو مستوى بحر
    } كما يقول ملفها ({ $heights })، وارتفاعات { $crs } من { $from_ellipsoid ->
        [true] جيوئيد
       *[false] الإهليلج
    }: موقع الأرض { $above_m ->
        [none] مزاح في الارتفاع بمقدار ارتفاع الجيوئيد
       *[other] { SIGN($above_m) ->
            [minus] أدنى
           *[plus] أعلى
        } مما يجب بمقدار { AMOUNT($above_m, digits: 1) } م
    }، فيُزاح أفقيًا ما تظهره الصور منها؛ حوّل الارتفاعات
remark-mosaic-without-place = ليس للكتلة مواقع GNSS ولا نقاط ضبط: الموزاييك في نظام خاص بالكتلة، أطواله ليست أمتارًا والشمال فيه غير معروف، وقد لا تكون الأرض فيه أفقية
remark-mosaic-without-system = إحداثيات الموزاييك أمتار نحو الشرق والشمال من نقطة خط عرضها { FIXED($latitude_deg, digits: 6) } وخط طولها { FIXED($longitude_deg, digits: 6) }، ولا يستطيع ملفه ذكر ذلك: بالخيار --crs يصبح للكتلة نظام يُذكر
remark-orthophoto-units = شرق الصورة المصححة وشمالها بوحدات طول كل منها { $unit_m } م؛ وتؤخذ ارتفاعات أرضها بوحدات طول كل منها { $height_unit_m } م
remark-unsupported-edits = كُتب ملف المشروع قبل أن تُحفظ جميع النقاط المضبوطة: مع التعديلات تُضبط الكتلة بالنقاط المختارة وحدها، وهي أقل دقة
remark-unmeasured-points =
    نقاط ضبط وتحقق لا يذكرها أي قياس صوري ولا تشارك: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}و{ $points_more } أخرى
    }
remark-points-without-coordinates =
    نقاط بلا إحداثيات في جدول نقاط الضبط ولا تشارك: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}و{ $points_more } أخرى
    }
remark-unknown-points =
    قياسات صورية لا تشارك لأن نقاطها ليست في جدول نقاط الضبط: { $points }{ $points_more ->
        [0] {""}
       *[other] {" "}و{ $points_more } أخرى
    }
remark-unknown-columns =
    أعمدة في جدول نقاط الضبط غير مفهومة ولا تُقرأ: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}و{ $columns_more } أخرى
    }
remark-doubled-columns =
    أعمدة في جدول نقاط الضبط تعطي ما يعطيه عمود آخر (بين قوسين) ولا تُقرأ: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}و{ $columns_more } أخرى
    }
remark-unnamed-errors =
    أعمدة بلا أسماء في جدول نقاط الضبط تُقرأ أخطاءً معيارية بالمتر: { $columns }؛ سمِّ الأعمدة إن كانت شيئًا آخر
remark-unknown-mark-columns =
    أعمدة في جدول القياسات الصورية غير مفهومة ولا تُقرأ: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}و{ $columns_more } أخرى
    }
remark-unnamed-position-errors =
    أعمدة بلا أسماء في جدول مواضع الصور تُقرأ أخطاءً معيارية بالمتر: { $columns }؛ سمِّ الأعمدة إن كانت شيئًا آخر
remark-unknown-position-columns =
    أعمدة في جدول مواضع الصور غير مفهومة ولا تُقرأ: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}و{ $columns_more } أخرى
    }
remark-position-heights =
    لا تُقرأ الارتفاعات { $positions ->
        [one] لموضع واحد
        [two] لموضعين
       *[other] لعدد من المواضع هو { $positions }
    } في جدول مواضع الصور: العمود '{ $column }' غير مفهوم، أو ليست فيه ارتفاعات فوق الإهليلجي كما تلزم مع خطوط الطول والعرض
remark-doubled-position-columns =
    أعمدة في جدول مواضع الصور تعطي ما يعطيه عمود آخر (بين قوسين) ولا تُقرأ: { $columns }{ $columns_more ->
        [0] {""}
       *[other] {" "}و{ $columns_more } أخرى
    }
remark-positions-of-other-images =
    { $all ->
        [true] لا يسمي جدول مواضع الصور أيًّا من الصور، ولا يُستعمل أي موضع منه؛ وهو يسمي
       *[false] يسمي جدول مواضع الصور صورًا أخرى أيضًا:
    } { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}و{ $images_more } أخرى
    }
remark-unused-camera = كاميرا { $images } لا توافق اسم أي صورة
remark-doubtful-focal =
    البعد البؤري لـ{ $label } هو { $focal_px } بكسل، أي { SIGNIFICANT($sides, digits: 2) } من الضلع الأطول للصورة، والمعتاد من { $least } إلى { $most }{ $in_mm ->
        [true] : هل هو بالمليمتر؟
       *[false] {""}
    }
remark-far-principal-point = تبعد النقطة الرئيسية لـ{ $label } عن وسط الصورة { SIGNIFICANT($sides, digits: 2) } من ضلعها الأطول، والمعتاد حتى { $most }
remark-contradicted-focal =
    البعد البؤري المعطى لـ{ $label } هو { SIGNIFICANT($focal_px, digits: 4) } بكسل، بينما تذكر ملفات هذه الصور { SIGNIFICANT($file_px, digits: 4) } بكسل: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}و{ $images_more } أخرى
    }
remark-cautioned-cameras =
    { $camera_caution }: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}و{ $images_more } أخرى
    }
remark-like-scans =
    { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}و{ $images_more } غيرها
    } تبدو مسوحًا ضوئية لأفلام، لإطار مشترك بينها أو لأن أحجامها تختلف قليلًا: إن كانت كذلك فقِس علاماتها الإطارية واصنع منها صورًا لكاميرا مثالية (tiepoint film) تُبنى منها الكتلة
remark-impossible-positions =
    تُهمل مواضع GNSS وارتفاعات مستحيلة: { $images }{ $images_more ->
        [0] {""}
       *[other] {" "}و{ $images_more } أخرى
    }
    .images = { $name } ({ $value })

## What became of a point of the left image. `label`: as a list or a legend has it.

verdict-matched = مطابَقة: لا قاعدة ترفضها.
    .label = مطابَقة
verdict-no-descriptor = مرفوضة: تخرج نافذتها عن الصورة أو تتساوى جميع قيمها الرمادية، فلا شيء يُقارَن.
    .label = بلا نافذة
verdict-no-candidate = مرفوضة: لا مرشح في نافذة بحثها.
    .label = بلا مرشح
verdict-threshold = مرفوضة: أفضل مرشحيها غير مشابه بما يكفي.
    .label = العتبة
verdict-ambiguous = مرفوضة: ثاني أفضل مرشحيها يكاد يساوي الأفضل.
    .label = ملتبسة
verdict-many-to-one = مرفوضة: نقطة يسرى أخرى تطابق الموضع نفسه على نحو أفضل.
    .label = كثير إلى واحد
verdict-parallax = مرفوضة: اختلاف منظرها الصادي يحيد عن أقرب المطابقات، أو لا توافق هندسة المشهدين.
    .label = اختلاف المنظر الصادي
verdict-border = مرفوضة: يقع أفضل المواضع على حد نافذة البحث؛ وقد يكون الأفضل خارجه.
    .label = الحد
verdict-left-right = مرفوضة: عند المطابقة من الصورة اليمنى رجوعًا يشبهها موضع آخر في الصورة اليسرى أكثر.
    .label = تحقق اليسار واليمين
verdict-not-converged = مرفوضة: لا تؤكدها المطابقة بالمربعات الصغرى ضمن حدودها للشكل والبعد والتكرارات؛ أو لا تؤكد مطابقة واصفها، وتدل المطابقات المؤكدة حولها على موضع آخر.
    .label = غير مؤكدة
verdict-imprecise = مرفوضة: الخطأ المعياري لموضعها الأيمن كبير، كما على حافة تنزلق عليها.
    .label = غير دقيقة
verdict-frame = مرفوضة: لها الموضع نفسه في الإطارين، كحد الفيلم والعلامات الإطارية وشرائط البيانات.
    .label = الإطار
verdict-gross-error = طوبقت ثم رُفضت من التوجيه النسبي: متبقيها المعياري يتجاوز الحد الذي تضعه α₀.
    .label = خطأ جسيم
verdict-undecided = لا مطابقة تستعمل هذه النقطة.
    .label = غير مطابَقة

# What came of the orthophoto that a block was given.
on-orthophoto-linked =
    { $in_crs ->
        [true] ضُبطت الكتلة بالصورة المصححة في نظامها المرجعي للإحداثيات،
       *[false] تقع الكتلة في نظام الصورة المصححة،
    } بعدد { $points } من المواضع التي تظهر في { $linked } من { $images } من الصور{ $checks ->
        [0] ، دون نقاط تحقق
        [one] ؛ ويتحقق منها موضع واحد آخر
       *[other] ؛ وتتحقق منها { $checks } من المواضع الأخرى
    }{ $rejected ->
        [0] .
       *[other] ؛ ورُفض { $rejected } منها.
    }
on-orthophoto-by-hand =
    { $in_crs ->
        [true] ضُبطت الكتلة بالصورة المصححة في نظامها المرجعي للإحداثيات،
       *[false] تقع الكتلة في نظام الصورة المصححة،
    } بعدد { $points } من المواضع المقيسة يدويًا في { $linked } من { $images } من الصور.
on-orthophoto-not-linked = ليست الكتلة في نظام الصورة المصححة، وهي كما كانت دونها: { $not_linked }.

# How an orthophoto may have come to lie elsewhere than its images.
place-slip-zone = في المنطقة { $zone } من UTM يكون الموضع صحيحًا: هل سُمّي النظام خطأً؟
place-slip-exchanged = إذا تبادل x وy كان الموضع صحيحًا: x هو الشرق.
place-slip-other-half = في المنطقة نفسها من النصف الآخر للأرض (الشمالي أو الجنوبي) يكون الموضع صحيحًا: هل سُمّي النظام خطأً؟
place-slip-unit = إذا كانت الإحداثيات بوحدة { $given_in } كان الموضع صحيحًا.
place-slip-coordinate = إذا كان { $likely } في الوسط كان الموضع صحيحًا.
place-slip-exchanged-positions = إذا تبادل خط العرض وخط الطول في المواقع كانت هناك: تحقق من ترتيبهما.
place-slip-latitude-sign = إذا انعكست إشارة خطوط العرض كانت المواقع هناك: هل كُتب الشمال بدل الجنوب، أم تنقص الإشارة؟
place-slip-longitude-sign = إذا انعكست إشارة خطوط الطول كانت المواقع هناك: هل كُتب الشرق بدل الغرب، أم تنقص الإشارة؟
place-slip-both-signs = إذا انعكست إشارات خطوط العرض والطول كانت المواقع هناك: هل تنقص الإشارات؟
place-slip-unknown = هل هي الصورة المصححة لهذه الصور، وهل نظامها صحيح، أم المواقع خاطئة؟

# أين تلتقي القياسات الصورية لنقاط الضبط.
control-apart-heights = تلتقي هذه { SIGN($up_m) ->
        [minus] تحتها
       *[plus] فوقها
    } بمقدار { AMOUNT($up_m, digits: 2) } م في الوسيط، ولا تكاد تبتعد عنها أفقيًا. هل تُحسب الارتفاعات من صفر آخر (--geoid-m)، أم هي بوحدة أخرى؟
control-apart-places = تلتقي هذه على بعد { FIXED($across_m, digits: 2) } م منها أفقيًا و{ SIGN($up_m) ->
        [minus] تحتها
       *[plus] فوقها
    } بمقدار { AMOUNT($up_m, digits: 2) } م في الوسيط. هل هي في نظام إحداثيات مرجعي آخر، أم بوحدة أخرى؟

# Why a block is not in the system of an orthophoto.
not-linked-not-oriented = لم توجَّه
not-linked-own-system = للكتلة النظام المرجعي { $crs }، ولم يكن الإصدار الذي شغّلها يضبطها فيه بصورة مصححة
not-linked-other-system =
    نظامها المرجعي { $crs }، ولا سبيل إليه من نظام الصورة المصححة{ $orthophoto ->
        [none] {""}
       *[other] ، { $orthophoto }
    } ({ $failure }). أعطِ --crs نظام الصورة المصححة، أو أعد إسقاط الصورة المصححة
not-linked-few-images = أمكن وضع { $placed } من { $images } من الصور على الصورة المصححة، والمطلوب { $needed }: تحقق من أنها تُظهر الأرض نفسها ومن أن الارتفاعات ارتفاعات هذه الأرض
not-linked-few-points = { $points } من مواضع أرضها تظهر في صورتين أو أكثر، والمطلوب { $needed }
not-linked-disagreement = تناقض { $rejected } من { $points } من مواضع أرضها الكتلة: تحقق من الارتفاعات
not-linked-contradiction = تناقضها نقاط الضبط الأرضية. تضع الصورة المصححة الكتلة على { FIXED($x_m, digits: 2) } م في X و{ FIXED($y_m, digits: 2) } م في Y، و{ SIGN($z_m) ->
        [minus] أدنى
       *[plus] أعلى
    } بمقدار { AMOUNT($z_m, digits: 2) } م، مما تضعها هذه النقاط: تحقق من نظام كليهما وارتفاعاته
not-linked-failed = { $failure }

# Why an image has no place on an orthophoto.
not-placed-no-common-place =
    { $matches ->
        [0] لا تشبه أي نقطة موضعًا في الصورة المصححة
       *[other] من { $matches } من النقاط التي تشبه مواضع في الصورة المصححة يتفق { $agreeing } على موضع واحد، كما تشاء المصادفة
    }
not-placed-no-orientation = تتفق { $points } من النقاط على موضع، ولا يوافقها توجيه للصورة: قد تكون الكاميرا خاطئة أو الارتفاعات أو موضع الصورة المصححة وبكسلاتها
not-placed-not-confirmed = تقع { $agreeing } من { $links } من النقاط حيث يضعها التوجيه الذي وُجد، كما تشاء المصادفة
not-placed-failed = { $failure }

# What speaks against the place of an image.
placing-weakness-few-links = لا يربطها بالصورة المصححة إلا { $links } من النقاط؛ المطلوب { $needed }.
placing-weakness-coverage = تقع النقاط في { PERCENT($share, digits: 0) } من الصورة؛ المطلوب { PERCENT($needed, digits: 0) }.
placing-weakness-checks = تناقض { $beyond } من { $checks } من النقاط التي لم تشارك هذا التوجيه.
placing-weakness-height = لا يُعرف الارتفاع فوق الأرض، وهو { FIXED($height_m, digits: 0) } م، إلا بحدود ± { SIGNIFICANT($half_width_m, digits: 2) } م (95 %): أعط كاميرا معايرة، ودقة الارتفاعات (--height-sigma-m).
placing-weakness-rejected = رُفض { $rejected } من { $links } من النقاط: تحقق من الارتفاعات والكاميرا.
placing-weakness-plan = لا يُعرف موضع مركز الإسقاط إلا بحدود ± { SIGNIFICANT($half_width_m, digits: 2) } م (95 %)، على { FIXED($height_m, digits: 0) } م فوق الأرض: تحقق من الكاميرا والارتفاعات ودقتها (--height-sigma-m).
placing-weakness-camera = تطلب النقاط { $camera_parameter } بمقدار { FIXED($estimated_px, digits: 1) } بكسل، والمعروف { FIXED($prior_px, digits: 1) } بكسل، والفرق { FIXED($apart, digits: 1) } انحرافًا معياريًا منه: تحقق من الكاميرا والارتفاعات.
placing-weakness-contradicted-focal = البعد البؤري المعطى { SIGNIFICANT($given_px, digits: 4) } بكسل، ويقول ملف الصورة { SIGNIFICANT($file_px, digits: 4) } بكسل: ويخطئ الارتفاع بقدر خطأ هذا البعد. تحقق من الكاميرا.
placing-weakness-height-factor = تطلب النقاط فروق ارتفاع تساوي { FIXED($factor, digits: 2) } ± { SIGNIFICANT($standard_error, digits: 1) } مرة من فروق الارتفاعات المعطاة: تحقق من أن الارتفاعات لهذه الأرض وبوحدة الصورة المصححة.
placing-weakness-relief = في { PERCENT($displaced, digits: 0) } من الصورة تقع النقاط معًا في غير الموضع الذي تحدده الارتفاعات: تحقق من أن الارتفاعات لهذه الأرض وبوحدة الصورة المصححة. منسوب واحد يصلح للأرض المستوية وحدها.
placing-weakness-gnss = تبعد أفقيًا { FIXED($plan_m, digits: 0) } م عن موقعها في GNSS، والمعتاد { FIXED($usual_m, digits: 0) } م على الأكثر: تحقق من النظام الإحداثي للصورة المصححة ومن الارتفاعات ومن الموقع.
placing-weakness-far-from-gnss = تبعد { SIGNIFICANT($distance_km, digits: 3) } كم عن موقعها في GNSS. { $place_slip }
placing-weakness-gnss-height =
    تقع { SIGN($height_m) ->
        [minus] أدنى
       *[plus] أعلى
    } من موقعها في GNSS بمقدار { AMOUNT($height_m, digits: 1) } م، والمعتاد { FIXED($usual_m, digits: 1) } م على الأكثر: تحقق من الارتفاعات، فهي منزاحة كلها أو محسوبة من صفر غير صفر الموقع، كمستوى سطح البحر بدل المجسم الإهليلجي (--heights-geoid-m)، ومن الموقع.
placing-weakness-noise = الجذر التربيعي لمتوسط مربعات المتبقيات { FIXED($rmse_px, digits: 2) } بكسل، وتبلغ الصور الجيدة { FIXED($usual_px, digits: 2) } بكسل: تحقق من الارتفاعات ومن عمر الصورة المصححة.

# How an image with a GNSS position was sought on an orthophoto.
place-search-gnss = عُثر عليها ضمن { FIXED($within_m, digits: 0) } م من موقعها في GNSS، وتبعد عنه أفقيًا { FIXED($plan_m, digits: 1) } م.
place-search-apart-from-gnss = تبعد أفقيًا { FIXED($plan_m, digits: 0) } م عن موقعها في GNSS، وهو صحيح عادةً ضمن { FIXED($usual_m, digits: 0) } م: تحقق من النظام الإحداثي للصورة المصححة ومن الارتفاعات ومن الموقع.
place-search-far-from-gnss = تبعد { SIGNIFICANT($distance_km, digits: 3) } كم عن موقعها في GNSS. { $place_slip }
place-search-height-apart-from-gnss =
    تقع { SIGN($height_m) ->
        [minus] أدنى
       *[plus] أعلى
    } من موقعها في GNSS بمقدار { AMOUNT($height_m, digits: 1) } م، وهو صحيح ضمن { FIXED($usual_m, digits: 1) } م: تحقق من الارتفاعات، فهي منزاحة كلها أو محسوبة من صفر غير صفر الموقع، كمستوى سطح البحر بدل المجسم الإهليلجي (--heights-geoid-m)، ومن الموقع.
place-search-beyond-gnss = لم يُعثر عليها ضمن { FIXED($within_m, digits: 0) } م من موقعها في GNSS؛ وبُحث في الصورة المصححة كلها.

# What the place of an image is worth.
placing-verdict-placed = وُضعت بعدد { $links } من النقاط، σ0 { FIXED($sigma0_px, digits: 2) } بكسل؛ مركز الإسقاط ± { SIGNIFICANT($half_width_m, digits: 2) } م (95 %).
placing-verdict-weak = وُضعت مع شك بعدد { $links } من النقاط. { $placing_weakness }
placing-verdict-not-placed = لم توضع: { $not_placed }.

error-wrong-type =
    { $document }: { $field ->
        [none] {""}
       *[other] { $field }:{" "}
    }أُعطي { $json_kind }؛ المسموح: { $allowed }
error-invalid-argument = { $what }: القيمة المعطاة { $got }؛ المسموح: { $wanted }
refusal-value = { $input }: أُعطي { $value } في { $location }؛ المسموح: من { $low } إلى { $high }
refusal-parameter = { $input }: أُعطي { $value } في { $field } من { $location }؛ المسموح: من { $low } إلى { $high }
refusal-index =
    { $input }: أُعطي الرقم { $index }؛ المسموح: { $count ->
        [0] لا شيء، إذ لا يوجد منها شيء
       *[other] أرقام دون { $count }
    }
refusal-below = { $input }: أُعطي { $index }؛ المسموح: ما دون { $count }
refusal-index-as = { $input }: أُعطي { $index } في { $location }؛ المسموح: من 0 إلى { $last }
refusal-nothing-as = { $input }: أُعطي { $index } في { $location }؛ المسموح: لا شيء، إذ لا يوجد منها شيء
refusal-count = { $input }: أُعطي { $got }؛ المسموح: { $wanted }
refusal-bytes = { $input }: أُعطي { $bytes } بايت؛ المسموح: مضاعفات { $each } بايت
refusal-numbers = { $input }: أُعطي { $numbers } من الأعداد؛ المسموح: مضاعفات { $each } من الأعداد
refusal-in-edit = { $refusal } (التعديل { $edit })

# Cameras and fiducial marks.
refusal-mark-coordinate = العلامات الإطارية: أُعطي { $coordinate } = { $value } في العلامة { $mark }؛ المسموح: أعداد من -{ $limit } إلى { $limit }
refusal-marks-again = العلامات الإطارية: أُعطيت العلامتان { $first } و{ $second } في الموضع نفسه؛ المسموح: كل علامة مرة واحدة
refusal-panorama = كاميرا الملف: أُعطيت بانوراما؛ المسموح: صورة بمنظور مركزي
refusal-mark-outside = العلامات الإطارية: أُعطيت علامة عند { $col }، { $row } بكسل لصورة ذات { $width } × { $height } بكسل؛ المسموح: علامات داخل الصورة، أو مبدأ الصورة في المسح الضوئي الذي قيست فيه
refusal-marks-sigma0 = العلامات الإطارية: ‏σ0 تبلغ { FIXED($sigma0_mm, digits: 3) } مم؛ المسموح: حتى { $most_mm } مم: بُدّلت علامات، أو في كتابة إحداها خطأ
refusal-marks-mirrored = العلامات الإطارية: أُعطيت علامات تقع معكوسة في المسح الضوئي؛ المسموح: مسح ضوئي للفيلم كما يُرى من أعلى: اقلب المسح، أو صحّح الإحداثيات
refusal-marks-skew = العلامات الإطارية: تنحرف أعمدة المسح الضوئي وصفوفه عن الزاوية القائمة بمقدار { FIXED($skew_deg, digits: 1) }°؛ المسموح: حتى { $most_deg }°: بُدّلت علامات، أو في كتابة إحداها خطأ
refusal-marks-scales = العلامات الإطارية: أُعطيت أعمدة وصفوف يختلف طولاها على الفيلم بنسبة { PERCENT($scales, digits: 1) }؛ المسموح: حتى { PERCENT($most, digits: 0) }: ربما كُتب إحداثي لعدة علامات خطأ
refusal-film-beside = مسح الفيلم: أُعطي { $width_px } × { $height_px } بكسل تقع خارج العلامات الإطارية؛ المسموح: صورة فيها جزء من الصورة الفوتوغرافية داخل علاماتها
refusal-film-pixel = حجم بكسل المسح المعاد معاينته: أُعطي { $pixel_mm } مم؛ المسموح: من { FIXED($least, digits: 5) } إلى { FIXED($most, digits: 5) } مم، من نصف بكسل المسح إلى ضعفه
refusal-film-without-camera = كاميرا الفيلم: لم تُعطَ مع العلامات الإطارية؛ المسموح: كاميرا معايرة مع بعدها البؤري بالمليمتر
refusal-lone-origin = المبدأ في المسح الضوئي: أُعطي { $origin } دون علامات إطارية؛ المسموح: مبدأ مع العلامات الإطارية المقيسة في ذلك المسح
refusal-one-camera = الكاميرتان: أُعطيت كاميرا واحدة؛ المسموح: كلتاهما أو لا واحدة
refusal-one-focal-length = الكاميرتان: أُعطي بعد بؤري واحد؛ المسموح: كلاهما أو لا واحد
refusal-cameras-of-block =
    كاميرا الزوج: أُعطيت كاميرات كتلة بأسماء صورها ({ $cameras ->
        [one] كاميرا واحدة
        [two] كاميرتان
       *[other] { $cameras } كاميرات
    })؛ المسموح: كاميرا واحدة، بعدًا بؤريًا بالبكسل أو ملفًا فيه focal_mm وprincipal_point_mm وpixel_mm، أو مشروع الكتلة الذي تأخذ منه صورها كاميراتها
refusal-no-cameras = الكاميرات: أُعطيت قائمة فارغة؛ المسموح: كاميرا واحدة أو أكثر
refusal-empty-pattern = الكاميرات: نمط الكاميرا { $camera } فارغ؛ المسموح: نمط أسماء مثل DJI_*.JPG
refusal-unused-patterns = الكاميرات: أُعطي { $patterns }، ولا يوافق ذلك أي صورة؛ المسموح: أنماط توافق أسماء مثل { $names }

# The model of a block.
refusal-image-name = صورة الكتلة: أُعطي الاسم { $name } للصورة { $image } (العد من 0)؛ المسموح: اسم بلا محارف تحكم
refusal-copy-of-image = صورة الكتلة: أُعطيت الصورة نفسها كما في { $name }؛ المسموح: كل صورة مرة واحدة
refusal-image-name-again = صورة الكتلة: أُعطي الاسم '{ $name }' للصورتين { $first } و{ $second } (العد من 0)؛ المسموح: كل اسم مرة واحدة
refusal-camera-of-image = كاميرا صورة: أُعطي الرقم { $camera } للصورة '{ $name }'؛ المسموح: أرقام دون { $cameras }
refusal-point-number-again = نقطة الكتلة: أُعطي الرقم { $number } للنقطتين { $first } و{ $second } (العد من 0)؛ المسموح: كل رقم مرة واحدة
refusal-point-numbers = نقطة الكتلة: أُعطي { $position } بمتبقيات قدرها { $rmse_px } بكسل للنقطة { $point } (العد من 0)؛ المسموح: أعداد منتهية
refusal-confidence = نقطة الكتلة: ثقة النقطة { $point } (العد من 0) خارج المجال من 0 إلى 1؛ المسموح: من 0 إلى 1
refusal-image-of-point = نقطة الكتلة: أُعطيت الصورة { $image } للنقطة { $point } (العد من 0)؛ المسموح: أرقام دون { $images }
refusal-ray-outside = نقطة الكتلة: تقع رصدة النقطة { $point } (العد من 0) عند ({ $x_px }, { $y_px }) في '{ $name }'؛ المسموح: مواضع ضمن { $width_px } × { $height_px } بكسل
refusal-two-rays = نقطة الكتلة: أُعطيت للنقطة { $point } (العد من 0) رصدتان في '{ $name }'؛ المسموح: رصدة واحدة في الصورة
refusal-rotation = صورة الكتلة: أُعطي { $rotation } دورانًا للصورة '{ $name }'؛ المسموح: مصفوفة دوران
refusal-image-position = صورة الكتلة: أُعطي { $position } موضعًا للصورة '{ $name }'؛ المسموح: أعداد منتهية
refusal-origin = مبدأ الكتلة: أُعطي خط الطول { $longitude_deg }° والعرض { $latitude_deg }° والارتفاع { $height_m } م؛ المسموح: خط طول وعرض وارتفاع حتى 1000 كم
refusal-other-coordinates = نقطة تحقق: إحداثيات { $point } من نوع آخر؛ المسموح: نوع إحداثيات نقاط الضبط
refusal-no-height = الارتفاع: لم يُعط لنقطة الضبط الأرضي { $point }؛ المسموح: من -100000 إلى 1000000
refusal-measured-image = قياس صوري لنقطة ضبط أرضي: أُعطي الرقم { $image } صورةً لنقطة الضبط الأرضي { $point }؛ المسموح: أرقام دون { $images }
refusal-measured-outside = قياس صوري لنقطة ضبط أرضي: أُعطي ({ $x_px }, { $y_px }) للنقطة { $point } في { $name }، خارج الصورة؛ المسموح: مواضع ضمن { $width_px } × { $height_px } بكسل
refusal-measured-twice = قياس صوري لنقطة ضبط أرضي: أُعطي قياسان للنقطة { $point } في { $name }؛ المسموح: قياس واحد في الصورة

# Points and their descriptors.
refusal-mask-size = القناع: أُعطي { $width } × { $height } بكسل؛ المسموح: أبعاد الصورة { $image_width } × { $image_height } بكسل
refusal-raster-order = نقاط الانتقاء: أُعطي تكرار أو ترتيب غير ترتيب الصفوف؛ المسموح: نقطة واحدة على الأكثر في البكسل، بالصف ثم بالعمود
refusal-described-point = نقطة للوصف: أُعطي ({ $x }, { $y }) بمقياس { $scale_px } بكسل؛ المسموح: مواضع داخل الصورة ذات { $width } × { $height } بكسل ومقاييس أكبر من 0 وحتى ضلعها الأطول
refusal-no-moments = الواصفات: أُعطي { $described } لعدد { $points } من النقاط؛ المسموح: عزوم كل نقطة
refusal-no-gradients = الواصفات: أُعطي { $described } لعدد { $points } من النقاط؛ المسموح: واصف تدرج لكل نقطة

# Matching.
refusal-neighbours-of-others = أقرب الجيران: أُعطي جيران النقاط اليسرى { $rows } بين { $among } من النقاط اليمنى؛ المسموح: جيران النقاط اليسرى 0..{ $left } بين { $right } من النقاط اليمنى
refusal-left-point = رقم نقطة يسرى: أُعطي { $index }؛ المسموح: ما دون { $count }، وهو عدد النقاط اليسرى
refusal-guide-matrix = المصفوفة الموجِّهة للبحث: أُعطي { $value }؛ المسموح: أعداد منتهية
refusal-described-positions = { $input }: أُعطي { $positions } من المواضع مع { $descriptors } من الواصفات؛ المسموح: واصفات بعدد المواضع
refusal-described-points = { $input }: أُعطي { $points } من النقاط مع { $descriptors } من الواصفات؛ المسموح: واصفات بعدد النقاط
refusal-described-bytes = { $input }: أُعطي { $positions } من المواضع مع { $bytes } بايت من الواصفات؛ المسموح: { $each } بايت لكل موضع
refusal-far-position = { $input }: أُعطي الموضع ({ $x }, { $y })؛ المسموح: مواضع من -1e6 إلى 1e6 بكسل
refusal-left-rows = صفوف الواصفات اليسرى: أُعطي من { $first } إلى { $end }؛ المسموح: تصاعدية، حتى { $left }
refusal-piece-lengths = قطعة من أقرب الجيران: أُعطي { $left } و{ $right } من الأعداد؛ المسموح: ثلاثة لكل واصف أيسر واثنان لكل واصف أيمن
refusal-piece-descriptor = قطعة من أقرب الجيران: أُعطي الواصف { $index }؛ المسموح: واصفات القطعة
refusal-piece-start = قطعة من أقرب الجيران: ليس أولها عددًا صحيحًا؛ المسموح: عدد صحيح
refusal-next-piece = القطعة التالية من أقرب الجيران: أُعطيت صفوف من { $row } مع { $right } من الواصفات اليمنى؛ المسموح: صفوف من { $next_row } مع { $of_right } من الواصفات اليمنى
refusal-offset-field = حقل الإزاحات: أُعطي { $columns } × { $rows } من العقد، و{ $offsets } من الإزاحات، والتباعد { $spacing_px } بكسل؛ المسموح: إزاحات منتهية بعدد الأعمدة × الصفوف، وتباعد أكبر من 0
refusal-match-position = مواضع المطابقات: أُعطي { $position } في المطابقة { $index } (العد من 0)؛ المسموح: من -1e6 إلى 1e6 بكسل

# Orientation.
refusal-shared-errors = الأخطاء المشتركة: أُعطيت آثار على { $effects } من الأرصاد، وعددها { $observations }؛ المسموح: أثر واحد لكل رصدة
refusal-oriented-observations = الأرصاد: أُعطي { $observations }؛ المسموح: الأرصاد التي وُجّهت، وعددها { $oriented }
refusal-observation-weight = الوزن: أُعطي { $weight } للرصدة { $observation } (العد من 0)؛ المسموح: من 1e-12 إلى 1e12
refusal-photo-coordinates =
    إحداثيات الصورة: أُعطي { FIXED($value_mm, digits: 3) } مم في الرصدة { $observation } (العد من 0)؛ المسموح: من -{ $largest_mm } إلى { $largest_mm } مم، أي { $focal_lengths } من أمثال البعد البؤري{ $tiny_mm ->
        [none] {""}
       *[other] ؛ وقد يكون البعد البؤري { $tiny_mm } مم معطى بالأمتار
    }

# Tie points.
refusal-place-of-image = موضع صورة: أُعطي { $position } للصورة { $image }؛ المسموح: أعداد منتهية بالمتر
refusal-similar-image = الصور المتشابهة: أُعطيت الصورة { $other } بتشابه { $similarity } في قائمة الصورة { $image }؛ المسموح: صور دون { $images } وأعداد
refusal-pair-of-images = زوج من الصور: أُعطي [{ $images }]؛ المسموح: صورتان مختلفتان من { $count }
refusal-pair-again = زوج من الصور: تكرر [{ $images }]؛ المسموح: كل زوج مرة واحدة
refusal-many-features = سمات الكتلة: أُعطي { $features } أو أكثر؛ المسموح: حتى { $most } من السمات في جميع الصور
refusal-many-matches = زوج من الصور: تبلغ المطابقات معه أكثر من { $most }؛ المسموح: مطابقات أقل في جميع الأزواج
refusal-matched-features = مطابقة: أُعطيت السمتان [{ $features }] بقوة { $strength } في المطابقة { $index } للصورتين [{ $images }]؛ المسموح: أرقام سمات دون { $left } و{ $right }، وقوة هي عدد
refusal-features-of-images = { $input }: أُعطيت سمات { $images } من الصور؛ المسموح: سمات صور الكتلة، وعددها { $wanted }
refusal-no-feature = نقاط الكتلة: أُعطيت السمة { $feature } للصورة { $image }؛ المسموح: سمات موجودة
refusal-no-tie-point = نقاط الكتلة: أُعطيت النقطة { $point }؛ المسموح: نقاط دون { $points }
refusal-feature-outside = سمات الصور: أُعطي { $position } في الصورة { $image } ذات { $width_px } × { $height_px } بكسل؛ المسموح: مواضع داخل صورتها
refusal-lost-feature = سمات الصور: لم يُعط موضع للسمة { $feature } من الصورة { $image }؛ المسموح: موضع لكل رصدة من أرصاد النقاط
refusal-ray-numbers = رصدة: أُعطي الموضع { $position } بمقياس { $scale_px }؛ المسموح: أعداد منتهية، ومقياس أكبر من 0 بكسل
refusal-ray-direction = اتجاه رصدة: أُعطي { $direction_rad }؛ المسموح: أعداد منتهية
refusal-ray-place = رصدة: أُعطي الموضع { $position }؛ المسموح: مواضع داخل الصورة ذات { $width } × { $height } بكسل
refusal-window-values = نوافذ الأرصاد: أُعطي { $values } من القيم الرمادية لعدد { $windows } من النوافذ؛ المسموح: { $side } × { $side } من القيم لكل نافذة
refusal-window-halvings = نوافذ الأرصاد: أُعطي { $halvings } من التنصيفات؛ المسموح: من 0 إلى { $most }
refusal-window-order = نوافذ الأرصاد: أُعطيت بترتيب آخر؛ المسموح: نوافذ مرتبة بالرصدة ثم بالتنصيفات، كل منها مرة واحدة

# Adjustment and reconstruction.
refusal-rotation-as = دوران صورة: أُعطي { $rotation } في { $location }؛ المسموح: صفوف متعامدة، طول كل منها 1، في نظام يميني
refusal-axis-direction = اتجاه محور: أُعطي { $direction } في { $location }؛ المسموح: متجه طوله 1
refusal-prior-again = القيم المسبقة للكاميرات: أُعطيت الكاميرا { $camera } (العد من 0) مرتين؛ المسموح: كل كاميرا مرة واحدة
refusal-control-again = نقاط الضبط: أُعطيت النقطة { $point } (العد من 0) مرتين؛ المسموح: كل نقطة مرة واحدة
refusal-ray-again = الأرصاد: أُعطيت رصدتان للنقطة { $point } (العد من 0) في الصورة { $image }؛ المسموح: رصدة واحدة على الأكثر لكل صورة ونقطة
refusal-mixed-positions = المواضع المرصودة: أُعطي { $geographic } من المواضع الجغرافية و{ $local } من المحلية؛ المسموح: كلها محلية أو كلها جغرافية، أو مواضع الصور وحدها ومواضع { $placing } من نقاط الضبط الأرضي أو أكثر
refusal-no-model = نموذج إعادة البناء: أُعطي النموذج { $model }؛ المسموح: نماذج دون { $models }
refusal-no-intersection = أرصاد نقطة: أُعطي { $rays } من أرصاد { $point_name }، ولا تلتقي أشعتها، أو تلتقي بزاوية صغيرة جدًا؛ المسموح: أشعة تلتقي ضمن { $largest_px } بكسل، بزاوية { $least_angle_deg }° أو أكثر

# Edits.
refusal-no-observation = صورة رصدة: أُعطيت { $location }، وليس فيها رصدة لـ{ $point_name }؛ المسموح: صور تُظهر النقطة
refusal-replaced-point = نقطة تُستعاد: أُعطيت نقطة صُنعت منها { $point_name } ولها أرصادها؛ المسموح: التراجع عن الخطوة التي صنعت { $point_name }، أو رفضها أولًا
refusal-rejected-point = نقطة مقيسة: أُعطيت { $point_name }، وهي لا تشارك؛ المسموح: نقاط مشاركة: استعدها أولًا
refusal-new-point-images = صور نقطة جديدة: أُعطي { $images } لعدد { $observations } من الأرصاد؛ المسموح: صورتان أو أكثر، كل منها مرة واحدة
refusal-measured-place = موضع مقيس: أُعطي ({ $x_px }, { $y_px }) في { $location }، خارج الصورة؛ المسموح: مواضع ضمن { $width_px } × { $height_px } بكسل
refusal-unknown-point = نقطة تعديل: أُعطيت { $point_name }؛ المسموح: نقاط الكتلة
refusal-image-not-oriented = صورة تعديل: أُعطيت { $location }، وهي غير موجَّهة؛ المسموح: صور موجَّهة من الكتلة
refusal-pair-not-connected = زوج تعديل: أُعطيت { $first } و{ $second }، ولا تصل بينهما مطابقات؛ المسموح: أزواج متصلة من الكتلة
refusal-block-not-oriented = كتلة التعديلات: أُعطيت كتلة غير موجَّهة؛ المسموح: كتلة موجَّهة
refusal-edits-of-other-block = كتلة التعديلات: أُعطيت كتلة بصور أو نقاط ربط أو نقاط ضبط أرضية أخرى؛ المسموح: الكتلة نفسها، موضوعة على صورة مصححة أو غير موضوعة
refusal-added-control-name = اسم نقطة ضبط أرضية جديدة: أُعطي { $name }، وهو فارغ أو اسم نقطة أخرى؛ المسموح: اسم خاص بها
refusal-added-control-errors = الأخطاء المعيارية لنقطة ضبط أرضية جديدة: أُعطي { $errors } للنقطة { $name }؛ المسموح: أعداد أكبر من 0

# Exchange formats and tables.
refusal-feature-numbers = سمة COLMAP: أُعطي { $numbers } للسمة { $feature }؛ المسموح: أعداد منتهية
refusal-feature-descriptor = سمة COLMAP: في واصف السمة { $feature } من الأعداد { $numbers }؛ المسموح: { $needed } من الأعداد
refusal-own-system = ‏GeoJSON: أُعطيت كتلة في نظام خاص بها؛ المسموح: كتلة مبدؤها معروف: ليس في GeoJSON إلا خطوط الطول والعرض
refusal-name-with-blanks = ‏{ $format }: أُعطي اسم الصورة '{ $name }'؛ المسموح: أسماء بلا فراغات
refusal-name-of-no-file = ‏{ $format }: أُعطي اسم الصورة '{ $name }'؛ المسموح: أسماء ملفات في مجلد
refusal-long-name = ‏{ $format }: أُعطي اسم الصورة '{ $name }' بطول { $bytes } بايت؛ المسموح: أسماء حتى { $most } بايت
refusal-no-records = { $input }: أُعطي { $words }؛ المسموح: أسطر من حقول تفصلها فواصل منقوطة أو علامات جدولة أو فواصل أو مسافات
refusal-quoted-lines = { $input }: أُعطي '{ $record }' من السطر { $line }، وفيه حقل بين علامتي اقتباس يمتد إلى السطر التالي؛ المسموح: علامات اقتباس تُغلق في سطرها
refusal-no-column = { $input }: ليس العمود { $column } في السطر الأول '{ $names }'؛ المسموح: سطر أول يسمي الأعمدة { $columns }
refusal-column-again = { $input }: أُعطي العمود { $column } مرتين؛ المسموح: سطر أول يسمي الأعمدة { $columns }
refusal-no-value = { $input }: لا قيمة في { $column } في السطر { $line }؛ المسموح: أعداد منتهية بنقطة عشرية
refusal-no-number = { $input }: أُعطي '{ $word }' في { $column } في السطر { $line }؛ المسموح: أعداد منتهية بنقطة عشرية
refusal-more-fields = { $input }: أُعطي '{ $record }' في السطر { $line }، وحقوله أكثر من الأعمدة المسماة وعددها { $columns }: الفواصل هنا تفصل الأعمدة وليست فواصل عشرية؛ المسموح: نقاط عشرية، أو أعمدة بين فواصل منقوطة أو علامات جدولة
refusal-blank-fields = { $input }: أُعطي '{ $record }' في السطر { $line } بين مسافات، وعدد أعمدة الجدول { $columns }؛ المسموح: العدد نفسه من الكلمات في كل سطر وليس منها فارغ، أو أعمدة بين فواصل منقوطة أو علامات جدولة أو فواصل
refusal-control-column = جدول نقاط الضبط: ليس في السطر الأول '{ $names }' عمود '{ $column }' (أو { $known }) ولا نقطة؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع، بين فواصل منقوطة أو علامات جدولة أو فواصل أو مسافات
refusal-head-unit = { $input }: أُعطي العمود '{ $column }' بوحدة { $given_in }؛ المسموح: إحداثيات بوحدة { $own }، أو في نظام إحداثيات بتلك الوحدة (--crs)
refusal-control-error-column = جدول نقاط الضبط: أُعطي العمود '{ $column }' دون الأخطاء المعيارية الأخرى؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع
refusal-control-error-unit = جدول نقاط الضبط: أُعطي العمود '{ $column }' بوحدة غير معروفة؛ المسموح: أخطاء معيارية بوحدات { $units }
refusal-control-numbers = جدول نقاط الضبط: أُعطي { $numbers } من الأعداد بعد الاسم في السطر { $line } ('{ $record }') دون أسماء للأعمدة؛ المسموح: x وy وz؛ أو هي مع الخطأين المعياريين للموضع وللارتفاع؛ أو هي مع أخطاء x وy والارتفاع، كل منها أكبر من 0 وحتى { $most_m } م. وتُقرأ الفواصل العشرية بين فواصل منقوطة أو علامات جدولة أو مسافات
refusal-control-lone-error = جدول نقاط الضبط: أُعطي عدد واحد '{ $word }' بعد الإحداثيات في السطر { $line } دون أسماء للأعمدة؛ المسموح: الخطآن المعياريان كلاهما، للموضع وللارتفاع، أو سطر يسمي الأعمدة
refusal-decimal-commas = { $input }: أُعطي '{ $record }' في السطر { $line }، وفواصله تفصل الأعمدة وقد تكون فواصل عشرية؛ المسموح: نقاط عشرية في عدد واحد على الأقل (1024.0 بدل 1024)، أو أعمدة بين فواصل منقوطة أو علامات جدولة أو مسافات
refusal-thousands = { $input }: أُعطي '{ $word }' في { $column } في السطر { $line }، ويبدو أن فيه علامات قبل الآلاف؛ المسموح: أعداد بلا هذه العلامات
refusal-thousands-commas = { $input }: أُعطي '{ $record }' في السطر { $line }، ولا يبيّن أي عدد في الجدول هل الفواصل فواصل آلاف أم فواصل عشرية؛ المسموح: نقاط عشرية بلا علامات قبل الآلاف
refusal-column-unit =
    { $input }: أُعطي العمود '{ $column }' بوحدة غير معروفة؛ المسموح: { $degrees ->
        [true] الدرجات أو { $units }
       *[false] { $units }
    }
refusal-system-line = { $input }: أُعطي السطر الأول '{ $words }' كما تبدأ جداول OpenDroneMap؛ المسموح: أسطر من name وx وy وz للنقاط في جدول، ومن image وpoint وx وy لقياساتها في جدول آخر، ونظام الإحداثيات وحده (--crs)
refusal-control-number = جدول نقاط الضبط: أُعطي '{ $word }' في { $column } في السطر { $line }؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع
refusal-control-name = جدول نقاط الضبط: الاسم '{ $name }' في السطر { $line } فارغ أو مكرر؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع
refusal-control-errors = جدول نقاط الضبط: ليست الأخطاء المعيارية { $errors } في السطر { $line } أكبر من 0؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع
refusal-reserved-name = اسم نقطة ضبط أرضية: أُعطي { $name }؛ المسموح: أسماء لا تبدأ بما تبدأ به مواضع الصورة المصححة، وهو { $begins }
refusal-control-use = جدول نقاط الضبط: أُعطي '{ $word }' استعمالًا في السطر { $line }، وهو control (أو GCP) أو check (أو check point) أو off، أما CP وحده فقد يكون أيًّا من الأولين؛ المسموح: أسطر من name وx وy وz، وقد يليها الخطآن المعياريان كلاهما، للموضع وللارتفاع
refusal-measured-column = جدول القياسات الصورية: ليس في السطر الأول '{ $names }' عمود '{ $column }' (أو { $known })، وهو يسمي أعمدة أخرى في غير ترتيب image وpoint وx وy؛ المسموح: سطر أول يسمي الأربعة كلها، أو أسطر من image وpoint وx وy
refusal-measured-numbers = جدول القياسات الصورية: أُعطي '{ $x }'، '{ $y }' موضعًا في السطر { $line }؛ المسموح: أسطر من image وpoint وx وy بنقاط عشرية، كل نقطة مرة واحدة في الصورة
refusal-measured-names = جدول القياسات الصورية: ليس في السطر { $line } اسم صورة أو نقطة؛ المسموح: أسطر من image وpoint وx وy بنقاط عشرية، كل نقطة مرة واحدة في الصورة
refusal-measured-again = جدول القياسات الصورية: تكررت النقطة '{ $point }' في الصورة '{ $image }' في السطر { $line }؛ المسموح: أسطر من image وpoint وx وy بنقاط عشرية، كل نقطة مرة واحدة في الصورة
refusal-position-column = جدول مواضع الصور: ليس في السطر الأول '{ $names }' عمود '{ $column }' (أو { $known })؛ المسموح: سطر أول يسمي الأعمدة، مثل image,latitude,longitude,height أو image,easting,northing,height، أو أسطر من image وx وy وheight
refusal-position-kinds = جدول مواضع الصور: أُعطي العمود '{ $x }' مع '{ $y }'؛ المسموح: خط الطول مع خط العرض، أو الشرق مع الشمال
refusal-position-number = جدول مواضع الصور: أُعطي '{ $word }' في { $column } في السطر { $line }؛ المسموح: أعداد منتهية (كما يكتبها ExifTool مع -n)، وفي كل سطر فيه إحداثي خط الطول وخط العرض، أو x وy، على الأقل
refusal-position-side = جدول مواضع الصور: أُعطي '{ $word }' في { $column } مع '{ $value }' في السطر { $line }؛ المسموح: N أو S مع خط العرض، وE أو W مع خط الطول، دون أن تناقضهما الإشارة؛ و0 أو 1 مع ارتفاع فوق مستوى البحر أو تحته
refusal-no-positions =
    جدول مواضع الصور: { $rows ->
        [0] ليس فيه سطر
        [1] فيه سطر واحد بلا إحداثيات
       *[other] أسطره بلا إحداثيات، وعددها { $rows }
    } ولا موضع فيه؛ المسموح: أسطر من الصورة وخط الطول وخط العرض والارتفاع، أو من الصورة وx وy والارتفاع، تحت سطر يسمي هذه الأعمدة
refusal-position-name = جدول مواضع الصور: أُعطي الاسم '{ $name }' في السطر { $line }؛ المسموح: أسماء ملفات الصور، غير فارغة وبلا محارف تحكم
refusal-position-errors = جدول مواضع الصور: أُعطي الخطأ المعياري { $errors } في السطر { $line }؛ المسموح: أعداد أكبر من 0، أو حقول فارغة
refusal-position-again = جدول مواضع الصور: تكرر موضع الصورة '{ $image }' في السطر { $line }؛ المسموح: كل صورة مرة واحدة
refusal-position-order = جدول مواضع الصور: أُعطي { $x } و{ $y } في السطر { $line }، وقد يكونان خط العرض ثم خط الطول أو العكس؛ المسموح: سطر أول يسمي الأعمدة، مثل image,latitude,longitude,height
refusal-position-degrees = جدول مواضع الصور: أُعطي خط الطول { $longitude_deg } وخط العرض { $latitude_deg } في السطر { $line }؛ المسموح: خطوط طول من -180 إلى 180 وخطوط عرض من -90 إلى 90 بالدرجات

# Coordinate reference systems.
refusal-unknown-crs = نظام الإحداثيات المرجعي: أُعطي { $crs }، وهو رمز غير معروف هنا، أو لإسقاط أو نوع غير مدعوم؛ المسموح: رموز EPSG لأنظمة جغرافية ومسقطة، أو نص PROJ
refusal-crs-text = نظام الإحداثيات المرجعي: أُعطي { $crs }، ولا يمكن قراءته ({ $reason })؛ المسموح: رمز EPSG (EPSG:25832) أو WKT أو نص PROJ بأحد الإسقاطات { $projections }
refusal-geocentric-crs = نظام الإحداثيات المرجعي: أُعطي { $crs }، وتلتقي محاوره في مركز الأرض؛ المسموح: أنظمة جغرافية ومسقطة
refusal-crs-axes = نظام الإحداثيات المرجعي: أُعطي { $crs }، وهو يذكر انتقال مرجع ويجعل الشمال قبل الشرق؛ المسموح: الشرق قبل الشمال مع انتقال مذكور
refusal-no-datum-shift =
    نظام الإحداثيات المرجعي: أُعطي { $crs }{ $name ->
        [none] {""}
       *[other] {" "}({ $name })
    }، ولا يُعرف انتقال من مرجعه إلى WGS 84 دون شبكة؛ المسموح: نص PROJ مع +datum=WGS84، أو مع الانتقال في +towgs84 (+towgs84=0,0,0 حيث يساوي المرجع WGS 84 إلا بضعة ديسيمترات)
refusal-crs-area = نظام الإحداثيات المرجعي: أُعطي { $crs } عند خط الطول { FIXED($longitude_deg, digits: 4) }° وخط العرض { FIXED($latitude_deg, digits: 4) }°، ولا يُعرف هناك انتقال من مرجعه إلى WGS 84؛ المسموح: مواضع في { $areas }. تحقق من المنطقة ومن ترتيب الإحداثيات
refusal-crs-place =
    الإحداثيات: أُعطي ({ $x }, { $y })، وهي خارج { $crs }؛ المسموح: { $degrees ->
        [true] خط الطول x من -180 إلى 180 وخط العرض y من -90 إلى 90 بالدرجات
       *[false] الشرق x والشمال y بوحدة هذا النظام
    }
refusal-outside-crs = المواضع: أُعطي خط الطول { FIXED($longitude_deg, digits: 4) }° وخط العرض { FIXED($latitude_deg, digits: 4) }°، وهو خارج { $crs }؛ المسموح: خط طول وخط عرض لمواضع يُظهرها إسقاطه
refusal-control-place =
    نقطة الضبط الأرضي { $point }: أُعطي ({ $x }, { $y })، وهي خارج { $crs }؛ المسموح: { $degrees ->
        [true] خط الطول x من -180 إلى 180 وخط العرض y من -90 إلى 90 بالدرجات
       *[false] الشرق x والشمال y بوحدة هذا النظام
    }
refusal-control-degrees = نقطة الضبط الأرضي { $point }: أُعطي ({ $x }, { $y })، وهي تشبه الدرجات؛ المسموح: الشرق x والشمال y كما في { $crs }
refusal-control-system =
    جدول نقاط الضبط: أُعطي نظام الإحداثيات '{ $words }' في السطر { $line } { $crs ->
        [none] ولا نظام غيره
       *[other] مع { $crs }
    }؛ المسموح: نقاط في نظام إحداثيات الكتلة (--crs)
refusal-position-system =
    جدول مواضع الصور: أُعطي نظام الإحداثيات '{ $words }' في السطر { $line } { $crs ->
        [none] ولا نظام غيره
       *[other] مع { $crs }
    }؛ المسموح: مواضع في نظام إحداثيات الكتلة (--crs)، أو خطوط طول وعرض من WGS 84 (EPSG:4326)
refusal-position-without-crs = جدول مواضع الصور: أُعطي ({ $x }, { $y }) في السطر { $line }، وليسا خط طول وخط عرض، بلا نظام إحداثيات؛ المسموح: خطوط طول وعرض بالدرجات، أو نظام إحداثيات للشرق والشمال (--crs)
refusal-position-place =
    جدول مواضع الصور: أُعطي ({ $x }, { $y }) في السطر { $line }، { $degrees ->
        [true] وهي تشبه الدرجات؛ المسموح: الشرق والشمال كما في { $crs }، أو عمودان باسمي longitude وlatitude
       *[false] وهي خارج { $crs }؛ المسموح: الشرق x والشمال y بوحدة هذا النظام
    }
refusal-control-elsewhere =
    نقطة الضبط الأرضي { $point }: أُعطي موضع يبعد { FIXED($distance_km, digits: 0) } كم عن مواضع GNSS للصور كما يضعه { $crs }؛ المسموح: حتى { $most_km } كم. { $swapped ->
        [true] إذا تبادل x وy فهو قريب منها: x هو الشرق أو خط الطول
       *[false] { $zone ->
            [none] { $likely ->
                [none] هل المنطقة صحيحة، أم مواضع GNSS خاطئة؟ دونها تشارك النقطة كما هي
               *[other] هو قريب منها إذا كان { $likely }
            }
           *[other] هو قريب منها في المنطقة { $zone }
        }
    }
refusal-control-zone =
    نقاط الضبط الأرضية: أُعطيت إحداثيات شرقية تبدأ برقم منطقة ({ $zone }، في { $x })، وهي في { $crs } بدونه؛ المسموح: { $code ->
        [none] {""}
       *[other] ‏--crs { $code }، أو{" "}
    }إحداثيات شرقية بدون { $zone } ({ $short })
refusal-control-unit =
    نقاط الضبط الأرضية: أُعطيت إحداثيات تقع { $near ->
        [true] قرب الصور
       *[other] في منطقة هذا النظام
    } إن كانت بوحدة { $given_in }؛ المسموح: إحداثيات في { $crs } ووحدتها { $own }
refusal-geoid-of-ellipsoid = ارتفاع الجيوئيد: أُعطي { $geoid_m } م مع { $crs } وارتفاعاته فوق الإهليلجي؛ المسموح: 0، أو نظام مستوٍ، أو نظام بارتفاعات فوق سطح البحر
refusal-geoid-file-of-ellipsoid = الجيوئيد: أُعطي { $name } مع { $crs } وارتفاعاته فوق الإهليلجي؛ المسموح: بلا جيوئيد، أو نظام مستوٍ، أو نظام بارتفاعات فوق سطح البحر
refusal-no-geoid = الجيوئيد: أُعطي { $name } وهو ليس مما يُقرأ؛ المسموح: GeoTIFF بخطوط الطول والعرض وشماله إلى أعلى، أو GTX، أو PGM من GeographicLib
refusal-geoid-elsewhere = الجيوئيد: أُعطي { $name } وهو يغطي خطوط الطول من { FIXED($west, digits: 2) } إلى { FIXED($east, digits: 2) } وخطوط العرض من { FIXED($south, digits: 2) } إلى { FIXED($north, digits: 2) }، لكتلة عند { FIXED($longitude_deg, digits: 4) }، { FIXED($latitude_deg, digits: 4) }، خطوط طولها من { FIXED($block_west, digits: 4) } إلى { FIXED($block_east, digits: 4) } وخطوط عرضها من { FIXED($block_south, digits: 4) } إلى { FIXED($block_north, digits: 4) }؛ المسموح: جيوئيد يغطي الكتلة
refusal-geoid-height =
    الجيوئيد: { $height ->
        [none] لا ارتفاع
       *[other] أُعطي { FIXED($height, digits: 2) } م
    } في { $name } عند { FIXED($longitude_deg, digits: 4) }، { FIXED($latitude_deg, digits: 4) }؛ المسموح: ارتفاعات فوق الإهليلجي من -200 إلى 200 م حول الكتلة كلها
refusal-geoid-nodes = الجيوئيد: أُعطي { $columns } × { $rows } من الارتفاعات حول الكتلة في { $name }؛ المسموح: حتى { $most }
refusal-geoid-twice = ارتفاع الجيوئيد: أُعطي { $geoid_m } م والملف { $name }؛ المسموح: أحدهما
refusal-geoid-without-crs = الجيوئيد: أُعطي { $name } بلا نظام إحداثيات؛ المسموح: نظام تُحسب ارتفاعاته منه (placing.crs)
refusal-geoid-without-place = الجيوئيد: أُعطي { $name } لكتلة ليس لها موضع على الأرض؛ المسموح: صور بمواضع GNSS، أو نقاط ضبط

# The run of a block.
refusal-measured-beyond = القياسات الصورية: أُعطي ({ $x_px }, { $y_px }) للنقطة { $point } في { $name }، خارج أي صورة؛ المسموح: مواضع داخل الصورة
refusal-measured-unknown = القياسات الصورية: أُعطيت النقطة { $point }؛ المسموح: نقاط من جدول نقاط الضبط
refusal-few-control-points =
    نقاط الضبط الأرضي: { $placing ->
        [0] { $checks ->
            [true] أُعطيت نقاط تحقق وحدها، وهي لا تُسند الكتلة جغرافيًا
           *[false] لم تُعطَ أي نقطة
        }
       *[other] قيس { $seen } من { $placing } في صورتين أو أكثر{ $checks ->
            [true] {" "}(لا تُحسب نقاط التحقق)
           *[false] {""}
        }
    }{ $images_count ->
        [0] {""}
        [one] ؛ وليست في الكتلة الصورة { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}…
        }
        [two] ؛ وليست في الكتلة الصورتان { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}…
        }
       *[other] ؛ وليست في الكتلة الصور { $images }{ $images_more ->
            [0] {""}
           *[other] {" "}…
        }
    }؛ المسموح: { $needed } أو أكثر{ $placing ->
        [0] {" "}مقيسة في صورتين أو أكثر
       *[other] {""}
    }، أو { $checks ->
        [true] لا نقاط ضبط ولا نقاط تحقق
       *[false] لا شيء منها
    }؛ وأي عدد مع مواضع GNSS لثلاث صور أو أكثر في نظام الإحداثيات نفسه (--crs) إن عُرف صفر الارتفاعات (--geoid، --geoid-m)، أو مع صورة مصححة (--orthophoto)
refusal-job-inputs = مدخلات مهمة: أُعطي { $inputs }؛ المسموح: المدخلات التي تسميها
refusal-mask-of-image = قناعها: أُعطي { $name } ذو { $width } × { $height } بكسل؛ المسموح: أبعاد الصورة { $image_width } × { $image_height } بكسل
refusal-file-name-again = صور الكتلة: أُعطيت صورتان بالاسم { $name }؛ المسموح: كل اسم مرة واحدة
refusal-file-name = صور الكتلة: أُعطي الاسم { $name }، وفيه محرف تحكم؛ المسموح: أسماء بلا محارف تحكم
refusal-coarse-descriptors = الواصفات الخشنة: أُعطي { $bytes } بايت؛ المسموح: { $each } بايت لكل منها
refusal-stray-masks =
    الأقنعة: أُعطي { $masks }{ $masks_more ->
        [0] {""}
       *[other] {" "}و{ $masks_more } غيرها
    }، { $masks_count ->
        [one] وهو لا يخص
       *[other] وهي لا تخص
    } أيًا من الصور؛ المسموح: أقنعة بأسماء الصور، مثل IMG_1.png أو IMG_1_mask.png أو IMG_1.jpg.png للصورة IMG_1.jpg
refusal-two-masks = الأقنعة: أُعطي { $first } و{ $second }، وهما للصورة نفسها؛ المسموح: قناع واحد للصورة
refusal-refined-observations = أرصاد نقطة: أُعطي من { $first } إلى { $end }؛ المسموح: أرقام تصاعدية حتى { $windows }
refusal-freed-object = حُرّر الكائن أو نُقل إلى كائن آخر؛ المسموح: كائنات لم تُحرّر ولم تُنقل
refusal-unknown-job = مهمة: أُعطي { $job }؛ المسموح: مهام جارية
refusal-few-images =
    صور الكتلة: قُرئ { $read } من { $given }{ $first ->
        [none] {""}
       *[other] {" "}({ $first }: { $failure })
    }؛ المسموح: صورتان أو أكثر
refusal-chosen-feature = الأرصاد: أُعطيت السمة { $feature }؛ المسموح: سمات دون { $features }

# The ground: orthophotos, heights, mosaics.
refusal-link-position = موضع رابط: أُعطي { $position } للرابط { $link }؛ المسموح: داخل الصورة ذات { $width_px } × { $height_px } بكسل
refusal-link-beside-frame = موضع رابط: أُعطي { $position } للرابط { $link }؛ المسموح: داخل العلامات الإطارية للمسح الضوئي
refusal-link-place = مكان رابط على الأرض: أُعطي { $place } للرابط { $link }؛ المسموح: حيث لأرض الصورة المصححة ارتفاع
refusal-place-without-height = موضع على الأرض: أُعطي { $place }؛ المسموح: حيث لأرض الصورة المصححة ارتفاع
refusal-place-system = موضع من صورة مصححة: أُعطي موضع من نظام لا يقود منه شيء إلى { $crs } ({ $failure })؛ المسموح: مواضع صورة مصححة يقود نظامها إلى هناك
refusal-world-file = ملف الإحداثيات (world file): أُعطي { $text }؛ المسموح: ستة أعداد، عدد في كل سطر: A وD وB وE للبكسل، وX وY لمركز البكسل العلوي الأيسر
refusal-georeference = الإسناد الجغرافي: أُعطي { $numbers }؛ المسموح: إحداثيات منتهية وبكسلات لها امتداد
refusal-mirrored-picture =
    الإسناد الجغرافي لصورة الأرض: أُعطي A = { $a } وD = { $d } وB = { $b } وE = { $e } لبكسلاتها كما في ملف world، وبها { $rows_go_north ->
        [true] تتجه الصفوف شمالًا (E فوق 0)
       *[false] تنعكس الصورة كما في المرآة
    }؛ المسموح: صفوف تتجه جنوبًا حيث تتجه الأعمدة شرقًا (A فوق 0 وE تحت 0)، أو صورة كهذه مُدارة كلها (A·E - B·D تحت 0). يكتبها gdalwarp كذلك
refusal-degrees = إحداثيات صورة الأرض: أُعطي خط الطول والعرض بالدرجات؛ المسموح: نظام إسقاط بالأمتار أو الأقدام: أعد إسقاطها، بالأمر gdalwarp -t_srs مثلًا
refusal-height-count = نموذج الارتفاعات: أُعطي { $heights } من الارتفاعات لأبعاد { $width } × { $height }؛ المسموح: ارتفاع لكل موضع، من 2 × 2 من المواضع أو أكثر؛ وفي الملف المبتور أقل
refusal-height-range = ارتفاعات نموذج الارتفاعات: أُعطي من { $low } إلى { $high }؛ المسموح: من -1000 إلى 20000، وفيها ارتفاع واحد على الأقل؛ ويجب التصريح بالقيمة الدالة على «لا ارتفاع»
refusal-no-height-model = نموذج الارتفاعات: ليس TIFF ولا نصًا؛ المسموح: GeoTIFF أو شبكة ESRI ASCII
refusal-heights-without-place = نموذج الارتفاعات: أُعطي TIFF لا يذكر موضعه؛ المسموح: GeoTIFF، أو ملف إحداثيات (world file) بجانبه
refusal-many-heights = نموذج الارتفاعات: أُعطي { $width } × { $height } من الارتفاعات؛ المسموح: حتى 100 مليون، أو 4000 مليون في GeoTIFF لا تزيد بلاطاته أو شرائطه على 16 مليونا
refusal-heights-of-picture = نموذج الارتفاعات: أُعطي TIFF بأعداد صحيحة من 8 بت كما في الصور؛ المسموح: أعداد من 16 بت أو أكثر، أو GeoTIFF يذكر بنظام رأسي أو بوحدة ارتفاع أو بمقياس وإزاحة من GDAL أنها ارتفاعات
refusal-height-samples = نموذج الارتفاعات: أُعطي TIFF بعينات من نوع آخر؛ المسموح: عينة واحدة في البكسل: أعداد صحيحة أو فاصلة عائمة
refusal-grid-word = شبكة ESRI ASCII: أُعطي { $name } بلا عدد؛ المسموح: ncols وnrows وxllcorner أو xllcenter وyllcorner أو yllcenter وcellsize وnodata_value، ثم الارتفاعات صفًا فصفًا
refusal-grid-lacks = شبكة ESRI ASCII: تنقصها { $name }؛ المسموح: ncols وnrows وxllcorner أو xllcenter وyllcorner أو yllcenter وcellsize وnodata_value، ثم الارتفاعات صفًا فصفًا
refusal-grid-size = شبكة ESRI ASCII: أُعطي { $columns } من الأعمدة و{ $rows } من الصفوف بخلية { $cell }؛ المسموح: ncols وnrows وxllcorner أو xllcenter وyllcorner أو yllcenter وcellsize وnodata_value، ثم الارتفاعات صفًا فصفًا
refusal-grid-height = شبكة ESRI ASCII: أُعطي { $word } بين الارتفاعات؛ المسموح: ncols وnrows وxllcorner أو xllcenter وyllcorner أو yllcenter وcellsize وnodata_value، ثم الارتفاعات صفًا فصفًا
refusal-picture-without-place = الصورة المصححة: أُعطي { $format } لا يذكر موضعه؛ المسموح: GeoTIFF، أو ملف إحداثيات (world file) بجانب الصورة (.tfw، .jgw، .pgw، .wld)
refusal-orthophoto-unit = الصورة المصححة: أُعطيت وحدة طول رمزها في EPSG { $code }؛ المسموح: 9001 (متر)، 9002 (قدم)، 9003 (قدم المساحة الأمريكية)
refusal-orthophoto-system =
    نظام الإحداثيات المرجعي للصورة المصححة: أُعطي { $described ->
        [none] لا شيء
       *[other] { $described }، وهو موصوف دون رمز، وليس بكل معاملات إسقاط مركاتور المستعرض أو لامبرت المخروطي المطابق بدرجات من غرينتش
    }؛ المسموح: رمز EPSG، يكتبه مثلًا gdal_edit.py -a_srs EPSG:25832، أو لا شيء حيث للكتلة نظام مسقط
refusal-nothing-above-ground = كتلة الموزاييك: ليس فيها صورة موجَّهة فوق الأرض؛ المسموح: صورة واحدة أو أكثر
refusal-mosaic-pixel = ضلع بكسل الموزاييك: أُعطي { $gsd }؛ المسموح: { FIXED($least, digits: 4) } أو أكثر، حتى لا يتجاوز الموزاييك { $megapixels } ميغابكسل، وتتسع الذاكرة لما ينتظر صورًا أخرى
refusal-mosaic-name = صورة موزاييك: أُعطيت { $name }؛ المسموح: صور الكتلة الموجَّهة: { $names }
refusal-mosaic-image = صورة موزاييك: أُعطي الرقم { $image }؛ المسموح: رقم صورة من النموذج
refusal-mosaic-image-size = صورة موزاييك: أُعطي { $width } × { $height } بكسل؛ المسموح: { $width_px } × { $height_px } بكسل، كما في كاميرتها
refusal-mosaic-without-images = الموزاييك: لم تُضف إليه صورة موجَّهة؛ المسموح: صور الكتلة تُضاف واحدة واحدة قبل إنهائه
refusal-empty-mosaic = الموزاييك: ليس فيه شيء تُظهره صورة؛ المسموح: ارتفاعات تحت الصور وأدنى منها، وبكسل أصغر كثيرًا من الصورة
refusal-map-in-degrees = النظام الإحداثي المرجعي للكتلة: أُعطي { $crs } بالدرجات؛ المسموح لصورة للأرض: نظام مسقط، كنظام منطقتها في UTM: شغّل الكتلة بخيار `--crs` آخر
refusal-outside-map = موقع الكتلة: أُعطي موقع خارج { $crs }؛ المسموح: داخل هذا النظام الإحداثي المرجعي
refusal-heights-system = نظام نموذج الارتفاعات: أُعطي { $heights }؛ المسموح: { $ground }، وهو نظام الصورة المصححة أو الكتلة: حوّل الارتفاعات أولًا، بالأمر gdalwarp -t_srs مثلًا
refusal-no-heights-there = ارتفاعات نموذج الارتفاعات: لا ارتفاع تحت الصورة المصححة؛ المسموح: نموذج للأرض نفسها في النظام نفسه
refusal-one-coordinate = مكان قريب من صورة: أُعطي إحداثي واحد؛ المسموح: near_x وnear_y معًا، أو لا واحد منهما
refusal-near-place = مكان قريب من صورة: أُعطي { $place }؛ المسموح: ضمن { $within_m } م من الصورة المصححة التي ركناها عند { $first } و{ $last }
refusal-near-radius = نصف القطر حول المكان القريب من صورة: أُعطي { $within_m } م؛ المسموح: ما يتسع لضلع من { $least_px } بكسل من الصورة المصححة
refusal-folded-image = التشوه الشعاعي لكاميرا { $camera }: القيمة { $radial } تطوي الصورة قبل زواياها بكثير؛ المسموح: حدود للبعد عن النقطة الرئيسية مقسومًا على البعد البؤري، وكلاهما بالبكسل، يزداد بها هذا البعد
refusal-camera-size = كاميرا الصورة: أُعطي { $width_px } × { $height_px } بكسل؛ المسموح: { $width } × { $height } بكسل، كما في الصورة
refusal-grey-values = صورة رمادية: أُعطي { $width } × { $height } بكسل مع { $values } من القيم؛ المسموح: أضلاع من 1 بكسل على الأقل، وقيم بعدد العرض × الارتفاع

# Epipolar images.
refusal-epipolar-name = صورة للصورتين القطبيتين: أُعطيت { $name }؛ المسموح: أسماء صور المشروع
refusal-epipolar-names = صورتان للصورتين القطبيتين: أُعطيت { $name } مرتين؛ المسموح: صورتان مختلفتان
refusal-epipolar-not-oriented = صورة للصورتين القطبيتين: أُعطيت { $name } وهي غير موجَّهة؛ المسموح: صور موجَّهة
refusal-epipolar-no-pair = كتلة للصورتين القطبيتين: لا صورتين موجَّهتين فيها لهما نقاط مشتركة؛ المسموح: زوج واحد أو أكثر
refusal-epipolar-base = صورتان للصورتين القطبيتين: أُعطيت { $left } و{ $right } ولا قاعدة بينهما (دوران خالص)؛ المسموح: صورتان التُقطتا متباعدتين
refusal-epipolar-along-base = صورتان للصورتين القطبيتين: أُعطيت { $left } و{ $right } وهما تنظران على امتداد قاعدتهما؛ المسموح: صورتان تنظران عبر قاعدتهما
refusal-epipolar-overlap = صورتان للصورتين القطبيتين: أُعطيت { $left } و{ $right } وليس لهما صفوف وأعمدة مشتركة؛ المسموح: صورتان متداخلتان
refusal-epipolar-image-size = صورة للصورتين القطبيتين: أُعطيت { $width } × { $height } بكسل لـ { $name }؛ المسموح: { $width_px } × { $height_px } بكسل، كما في المشروع

# Simulated photos and their truth.
refusal-photo-position = موضع في صورة: أُعطي { $position }؛ المسموح: مواضع داخل الصورة ذات { $width_px } × { $height_px } بكسل
refusal-truth-of-others = حقيقة الكتلة: ليس فيها شيء من صور الكتلة؛ المسموح: حقيقة هذه الصور
refusal-truth-not-oriented = حقيقة الكتلة: أُعطيت '{ $name }' بلا توجيه؛ المسموح: صور موجَّهة
refusal-truth-distortion = حقيقة الكتلة: أُعطي تشوه للكاميرا { $camera }؛ المسموح: كاميرات بلا تشوه
refusal-truth-size = الحقيقة: أُعطي { $positions } من المواضع لأبعاد { $width } × { $height } بكسل؛ المسموح: موضع واحد لكل بكسل من الصورة اليسرى

# Projects.
refusal-pair-match = مطابقة الزوج: أُعطي { $left } و{ $right }؛ المسموح: نقاط دون { $points } و{ $others }
refusal-pair-found = المطابقات المعثور عليها في الزوج: أُعطيت أحكام { $found } نقطة؛ المسموح: { $points } على الأكثر
refusal-pair-place = موضع مطابقة معدَّلة: أُعطي { $got }؛ المسموح: أعداد منتهية من px
refusal-pair-rejected = مطابقة مرفوضة من الزوج: أُعطي { $index }؛ المسموح: مطابقات دون { $matches }
refusal-project-connection = وصلة المشروع: أُعطي [{ $images }]؛ المسموح: صورتان دون { $count } بترتيب تصاعدي
refusal-project-geoid = جيوئيد المشروع: أُعطيت أعداد ليست أعداد شبكة؛ المسموح: ارتفاعات بعدد الصفوف والأعمدة، اثنان أو أكثر
refusal-step-without-edits = خطوات التعديلات: أُعطيت خطوة بلا تعديلات؛ المسموح: تعديل أو أكثر في كل خطوة
refusal-project-edits = تعديلات المشروع: أُعطيت تعديلات كتلة غير موجَّهة؛ المسموح: تعديلات كتلة موجَّهة
refusal-project-image = صورة المشروع: أُعطيت '{ $name }' من الكاميرا { $camera }؛ المسموح: '{ $other }' من الكاميرا { $other_camera }
refusal-project-index = نموذج المشروع: أُعطي الرقم { $index }؛ المسموح: صور دون { $images } وكاميرات دون { $cameras }
refusal-project-camera = نموذج المشروع: أُعطيت الكاميرا { $camera } لصورة؛ المسموح: كاميرات دون { $cameras }
refusal-project-strip = نموذج المشروع: أُعطي الشريط { $strip } لخطأ في مواضع GNSS؛ المسموح: شرائط دون { $strips }
refusal-project-order = نموذج المشروع: أُعطيت صور غير مرتبة؛ المسموح: صور بترتيب تصاعدي، كل منها مرة واحدة
refusal-project-observation = نموذج المشروع: أُعطيت رصدة للنقطة { $point } في الصورة { $image }؛ المسموح: صور دون { $images } ونقاط دون { $points }

## What is given.
input-axis-sigma = الخطأ المعياري لمحور
input-base = القاعدة
input-camera-distortion = تشوه كاميرا
input-camera-focal-length = البعد البؤري لكاميرا
input-camera-of-image = كاميرا صورة
input-camera-of-prior = كاميرا قيمة مسبقة
input-camera-parameter = معامل كاميرا
input-camera-principal-point = النقطة الأساسية لكاميرا
input-camera-sigma = الخطأ المعياري لكاميرا
input-features-of-images = سمات الصور
input-fiducial-table = جدول العلامات الإطارية
input-control-table = جدول نقاط الضبط
input-free-radial = المعاملات الشعاعية الحرة
input-height = الارتفاع
input-image = الصورة
input-image-coordinates = إحداثيات الصورة
input-image-of-ray = صورة رصدة
input-image-size = أبعاد الصور
input-geometries-of-project = هندسات المشروع
input-images-of-project = صور المشروع
input-cameras-of-project = كاميرات المشروع
input-points-of-project = نقاط المشروع
input-edits-of-steps = تعديلات كل الخطوات معًا
input-observations-of-point = أرصاد نقطة من المشروع
input-images-of-model = صور نموذج من المشروع
input-images-of-block = صور كتلة مضبوطة من المشروع
input-cameras-of-block = كاميرات كتلة مضبوطة من المشروع
input-points-of-model = نقاط نموذج من المشروع
input-observations-of-model = أرصاد نموذج من المشروع
input-places-of-strip = أماكن صور شريط من المشروع
input-verdicts-of-pair = أحكام الزوج
input-matched-of-pair = النقاط المطابَقة من الزوج
input-frames-of-pair = أطر نقاط الزوج
input-observations-of-pair = أرصاد الزوج
input-residuals-of-pair = متبقيات الزوج
input-scores-of-pair = درجات الزوج
input-latitude = خط العرض
input-left-descriptors = الواصفات اليسرى
input-left-features = السمات اليسرى
input-left-points = النقاط اليسرى
input-longitude = خط الطول
input-mark-table = جدول القياسات الصورية
input-observation-table = جدول الأرصاد
input-photo-of-block = صورة من الكتلة
input-pixel-side = ضلع بكسل
input-point = النقطة
input-point-of-control = نقطة لنقطة ضبط
input-point-of-ray = نقطة رصدة
input-points-of-block = نقاط الكتلة
input-position = الموضع
input-position-sigma = الخطأ المعياري لموضع
input-position-table = جدول مواضع الصور
input-mark-sigma = الخطأ المعياري لقياس في الصورة
input-ray-sigma = الخطأ المعياري لرصدة
input-right-descriptors = الواصفات اليمنى
input-right-features = السمات اليمنى
input-right-points = النقاط اليمنى
input-surveyed-point = نقطة ضبط أرضي أو تحقق
input-surveyed-point-of-block = نقطة ضبط أرضي أو تحقق من الكتلة
input-text = النص
input-weight = الوزن

## Where a value stands.
location-camera = الكاميرا { $camera } (العد من 0)
location-named-camera = { camera }
location-camera-of-file = الكاميرا { $camera } من الملف
location-camera-of-images = كاميرا { $images }
location-camera-of-image = كاميرا الصورة
location-camera-of-prior = كاميرا قيمة مسبقة
location-control = نقطة الضبط الأرضي { $name }
location-element-of-control = { $element } في نقطة الضبط { $control } (العد من 0)
location-element-of-image = { $element } في الصورة { $image } (العد من 0)
location-element-of-ray = { $element } في الرصدة { $ray } (العد من 0)
location-geometry = هندسة الصورة { $side }
location-image = { $name }
location-image-index = الرقم { $image }
location-pair = الزوج
location-point = النقطة { $point } (العد من 0)
location-prior = القيمة المسبقة للكاميرا { $camera } (العد من 0)
element-axis-direction = اتجاه المحور
element-axis-sigma = الخطأ المعياري للمحور
element-camera = الكاميرا
element-coordinates = الإحداثيات
element-gnss-position = موضع GNSS
element-gnss-sigma = الخطأ المعياري لموضع GNSS
element-image = الصورة
element-point = النقطة
element-position = الموضع
element-rotation = الدوران
element-sigma = الخطأ المعياري
element-weight = الوزن
point-name-control = { $name }
point-name-control-index = نقطة الضبط الأرضي أو التحقق { $point }
point-name-manual = النقطة اليدوية { $number }
point-name-tie-point = نقطة الربط { $number }
described-none = لا شيء
described-moments = { $descriptors } من واصفات العزوم
described-gradients = { $bytes } بايت من التدرجات

# Covariances of a finished block.
refusal-covariance-image = التباينات المشتركة: أُعطيت الصورة { $image } من الضبط (العد من 0)، وهي تنظر على امتداد المحور X؛ المسموح: صور تبتعد فيها φ عن ±90°: عندها ω وκ زاوية واحدة
refusal-covariance-point = التباينات المشتركة: أُعطيت النقطة { $point } من الضبط (العد من 0) وليس لها أرصاد مقبولة؛ المسموح: نقاط شاركت
refusal-covariances-not-oriented = التباينات المشتركة: أُعطيت كتلة غير موجَّهة؛ المسموح: كتلة موجَّهة
refusal-covariances-unsupported = التباينات المشتركة: أُعطي مشروع من إصدار سابق، ليست فيه جميع نقاط ضبطه؛ المسموح: مشاريع تحفظ جميع نقاط ضبطها
refusal-covariance-unknowns = التباينات المشتركة: أُعطي { $unknowns } من المجاهيل؛ المسموح: من 1 إلى { $most } من المجاهيل: ستة للصورة، وثلاثة للنقطة
refusal-covariance-again = اسم تباين مشترك: أُعطي { $name } مرتين؛ المسموح: كل اسم مرة واحدة
refusal-accuracy-images = خريطة الدقة المتوقعة: أُعطيت كتلة فيها { $images } صورة؛ المسموح: حتى { $most }
refusal-accuracy-sigma = الخطأ المعياري لإحداثي الصورة: أُعطي { $sigma_px } بكسل؛ المسموح: أكبر من 0، حتى 1000 بكسل
refusal-accuracy-cell = ضلع خلية الخريطة: أُعطي { $cell }؛ المسموح: من { FIXED($least, digits: 4) } إلى { FIXED($most, digits: 4) }، بوحدة الكتلة
refusal-covariance-name = اسم تباين مشترك: أُعطي { $name }؛ المسموح: أسماء صور موجَّهة ونقاط ضبط أرضي وتحقق مضبوطة، وpoint:N كما في points.csv، وcamera:N كما في images.csv، أو all

## What is computed.

## Of the adjustment of a block: observations whose standard errors are stated together, and systematic errors of GNSS positions.

observation-group-marks = القياسات الصورية
observation-group-gnss-plan = مواضع GNSS، الأفقية
observation-group-gnss-height = مواضع GNSS، الارتفاعات
observation-group-control-plan = نقاط الضبط، الأفقية
observation-group-control-height = نقاط الضبط، الارتفاعات
place-group-places-plan = مواضع الصورة المصححة، الأفقية
place-group-places-height = مواضع الصورة المصححة، الارتفاعات
place-group-control-and-places-plan = نقاط الضبط ومواضع الصورة المصححة، الأفقية
place-group-control-and-places-height = نقاط الضبط ومواضع الصورة المصححة، الارتفاعات

# Cameras and strips are counted from 0: NTH gives the number that people count by.
systematic-error-lever-arm = ذراع الهوائي للكاميرا { NTH($camera) }
systematic-error-offset = إزاحة مواضع GNSS
systematic-error-strip-offset = إزاحة GNSS لخط الطيران { NTH($strip) }
systematic-error-strip-drift = انجراف GNSS لخط الطيران { NTH($strip) }

systematic-verdict-kept = باقٍ
systematic-verdict-not-significant = غير ذي دلالة، صفر
systematic-verdict-undetermined = غير محدَّد، صفر

## The steps of the report of a pair.

report-step-this-run = هذا التشغيل
report-step-this-run-edited = هذا التشغيل، معدَّلًا
report-step-moments = العزوم
report-step-invariants = اللامتغيرات
report-step-correlation = الارتباط
report-step-least-squares = المربعات الصغرى
report-step-gradients = التدرجات
